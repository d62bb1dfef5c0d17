// Where the reader was in the overview, to come back to: by the card, as what is above it has no sure height.

// Cards get their heights when they are drawn, and move those below them; after
// so many frames they have them.
const FRAMES_TO_SETTLE = 6;

const overviewPlace = {
  scroll: 0,
  // How far below the top of the window the card was that was opened; null where
  // it was not seen, as when a link has led elsewhere.
  top: null,

  keep(name) {
    const card = cards.get(fixtureByName.get(name)?.index)?.root;
    const { top, bottom } = card?.getBoundingClientRect() ?? {};
    this.scroll = window.scrollY;
    this.top = card?.isConnected && bottom > 0 && top < window.innerHeight ? top : null;
  },

  // Puts the card of `fixture` there, be it the one that was opened or a later one.
  restore(fixture) {
    const card = cards.get(fixture?.index)?.root;
    window.scrollTo(0, this.scroll);
    if (!card?.isConnected) return;
    if (this.top === null) card.scrollIntoView({ block: "nearest" });
    else settle(card, this.top, FRAMES_TO_SETTLE);
  },
};

function settle(card, top, frames) {
  if (!card.isConnected) return;
  window.scrollBy(0, card.getBoundingClientRect().top - top);
  if (frames > 0) requestAnimationFrame(() => settle(card, top, frames - 1));
}
