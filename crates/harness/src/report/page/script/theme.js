// Light and dark: the system's choice, until the reader makes one.

const THEME = "goldray-theme";

function isDark() {
  const chosen = document.documentElement.dataset.theme;
  return chosen ? chosen === "dark" : matchMedia("(prefers-color-scheme: dark)").matches;
}

function nameTheme() {
  byId("theme").textContent = isDark() ? "Light" : "Dark";
  byId("theme").setAttribute("aria-label", `${isDark() ? "Light" : "Dark"} colors`);
}

function startTheme() {
  const chosen = stored(THEME);
  if (chosen) document.documentElement.dataset.theme = chosen;
  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", nameTheme);
  byId("theme").addEventListener("click", () => {
    document.documentElement.dataset.theme = isDark() ? "light" : "dark";
    stored(THEME, document.documentElement.dataset.theme);
    nameTheme();
  });
  nameTheme();
}
