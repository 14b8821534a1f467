package lightning.shading;

import java.util.Arrays;

/**
 * What anti-aliasing sees of the pixels of a tile by their centres: neighbouring pixels whose codes differ have an edge
 * between them. A pixel that hits nothing has code 0. Arrays are never written after construction.
 *
 * @param shapes   edges of shapes, textures and of the images of those in mirrors: {@code int[1024]}; no edit of a light changes it
 * @param lights   edges of shadows, cones and highlights, in mirrors too: {@code int[1024]}
 * @param mirrored the share in {@code lights} that comes over mirrors: {@code int[1024]}, or null where nothing does
 */
public record EdgeCodes(int[] shapes, int[] lights, int[] mirrored) {

    /** Where the two are alike, {@code known}, so that who compares them later need not look inside. */
    public EdgeCodes or(EdgeCodes known) {
        boolean alike = known != null && Arrays.equals(shapes, known.shapes) && Arrays.equals(lights, known.lights)
                && Arrays.equals(mirrored, known.mirrored);
        return alike ? known : this;
    }

    /** The bytes of the arrays. */
    public long bytes() {
        return 4L * (shapes.length + lights.length + (mirrored == null ? 0 : mirrored.length));
    }
}
