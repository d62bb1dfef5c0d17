// Base64, zlib and PNG into numbers, exactly.

function bytesOf(base64) {
  const text = atob(base64);
  const bytes = new Uint8Array(text.length);
  for (let i = 0; i < text.length; i++) bytes[i] = text.charCodeAt(i);
  return bytes;
}

async function inflate(base64) {
  const packed = new Blob([bytesOf(base64)]).stream();
  return new Response(packed.pipeThrough(new DecompressionStream("deflate"))).arrayBuffer();
}

// A canvas that is drawn to and read from, not seen.
function blankCanvas(width, height) {
  const canvas = element("canvas");
  canvas.width = width;
  canvas.height = height;
  return canvas;
}

function contextOf(canvas) {
  return canvas.getContext("2d", { willReadFrequently: true, colorSpace: "srgb" });
}

// A PNG as `{width, height, data, canvas}`, `data` with four codes for a pixel
// as they are in the file: a browser that adapts colors to a screen, or
// multiplies by alpha, would show differences that nobody rendered.
async function decodePng(base64) {
  if (!base64) return null;
  const blob = new Blob([bytesOf(base64)], { type: "image/png" });
  const bitmap = await createImageBitmap(blob, {
    colorSpaceConversion: "none",
    premultiplyAlpha: "none",
  });
  const { width, height } = bitmap;
  const canvas = blankCanvas(width, height);
  const context = contextOf(canvas);
  context.drawImage(bitmap, 0, 0);
  bitmap.close();
  return { width, height, data: context.getImageData(0, 0, width, height).data, canvas };
}

// Linear values, three for a pixel.
async function decodeLinear(base64) {
  if (!base64) return null;
  const view = new DataView(await inflate(base64));
  const values = new Float32Array(view.byteLength / 4);
  for (let i = 0; i < values.length; i++) values[i] = view.getFloat32(4 * i, true);
  return values;
}

// Which object each pixel shows: `{places, numbers}`, a number for each pixel,
// 0 for the background and n for `places[n - 1]`.
async function decodeObjects(objects) {
  if (!objects) return null;
  const view = new DataView(await inflate(objects.numbers));
  const numbers = new Uint32Array(view.byteLength / 4);
  for (let i = 0; i < numbers.length; i++) numbers[i] = view.getUint32(4 * i, true);
  return { places: objects.places, numbers };
}

// A golden that cannot be read is a verdict of its own: there is then none, and
// the rest is seen as well as without one.
async function decodeGolden(fixture, evidence) {
  if (fixture.verdict === "unreadable") return null;
  try {
    return await decodePng(evidence.golden);
  } catch {
    return null;
  }
}

// All pictures of a fixture, decoded; null is what there is not.
async function loadPictures(fixture, evidence) {
  const [golden, actual, ssim, flip, linear, objects] = await Promise.all([
    decodeGolden(fixture, evidence),
    decodePng(evidence.actual),
    decodePng(evidence.ssim),
    decodePng(evidence.flip),
    decodeLinear(evidence.linear),
    decodeObjects(evidence.objects),
  ]);
  const both = { golden, actual: isLeftOut(fixture, evidence) ? golden : actual };
  const isUnreadable = golden === null && Boolean(evidence.golden);
  const isGolden = isSame(both.golden, both.actual);
  return { ...both, isGolden, isUnreadable, ssim, flip, linear, objects };
}

// Whether two pictures are there and have the same codes.
function isSame(golden, actual) {
  if (!golden || !actual || golden.width !== actual.width || golden.height !== actual.height)
    return false;
  return golden === actual || golden.data.every((code, i) => code === actual.data[i]);
}
