// Blink: golden and actual picture in turn at one place, where the eye sees what moves.

// Half a second each: quick enough to see a change, far below what harms.
const BLINK_MS = 500;

const BLINK_VIEW = {
  id: "blink",
  key: "2",
  label: "Blink",
  lacks: lacksTwo,
  open(stage) {
    const { golden, actual } = stage.pictures;
    let isGoldenShown = true;
    const larger = {
      width: Math.max(golden.width, actual.width),
      height: Math.max(golden.height, actual.height),
    };
    const pane = makePane("Golden", larger, (draw) =>
      draw((isGoldenShown ? golden : actual).canvas),
    );
    const flip = () => {
      isGoldenShown = !isGoldenShown;
      pane.caption.textContent = isGoldenShown ? "Golden" : "Actual";
      stage.redraw();
    };
    const clock = makeClock(flip);
    const still = matchMedia("(prefers-reduced-motion: reduce)").matches;
    const automatic = element("input", {
      type: "checkbox",
      checked: !still,
      change: () => clock.run(automatic.checked),
    });
    clock.run(!still);
    // By hand it is looked at in peace.
    const byHand = () => {
      automatic.checked = false;
      clock.run(false);
      flip();
      speak(`${pane.caption.textContent} is shown`);
    };
    const controls = element(
      "div",
      { class: "controls" },
      button(["Flip ", element("kbd", { "aria-hidden": "true" }, "space")], byHand),
      element("label", {}, automatic, " by itself, twice a second"),
    );
    return { panes: [pane], controls, space: byHand, close: () => clock.run(false) };
  },
};

function makeClock(tick) {
  let timer = null;
  return {
    run(isOn) {
      clearInterval(timer);
      timer = isOn ? setInterval(tick, BLINK_MS) : null;
    },
  };
}
