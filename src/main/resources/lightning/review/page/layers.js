// Numbers of 16 bits as HalfPlanes writes them.
async function numbers(text, stride) {
  const packed = Uint8Array.from(atob(text), (c) => c.charCodeAt(0));
  const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream("deflate"));
  const bytes = new Uint8Array(await new Response(stream).arrayBuffer());
  const count = bytes.length / 2;
  const result = new Uint16Array(count);
  for (let i = 0; i < count; i++) {
    const before = i < stride ? 0 : result[i - stride];
    result[i] = (bytes[i] + before) & 255 | ((bytes[count + i] + (before >> 8)) & 255) << 8;
  }
  return result;
}
