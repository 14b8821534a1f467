package lightning.cache;

/**
 * The finer samples of one tile of the picture (anti-aliasing), and the pixels that they make together with the centres.
 *
 * @param shapes samples of pixels at an edge of what is hit, or of all pixels; they stay while lights are edited
 * @param lights samples of the other pixels at an edge of a light: a shadow, a cone, a highlight
 * @param film   the tile of the film: red, green, blue, {@code float[1024]} each
 */
public record FineTile(FineSamples shapes, FineSamples lights, float[][] film) {}
