package lightning.render.shading;

import java.util.Arrays;

/**
 * What anti-aliasing sees of the pixels of a tile by their centers: neighboring pixels whose codes differ have an edge
 * between them. A pixel that hits nothing has code 0. Arrays, {@code int[1024]} each, are never written after construction.
 *
 * @param shapes         edges of shapes and textures, and of their images in mirrors: no edit of a light changes it
 * @param lights         edges of shadows, cones and highlights, and of their images in mirrors
 * @param mirroredShapes the share in {@code shapes} that comes over mirrors, or null where nothing does
 * @param mirroredLights the share in {@code lights} that comes over mirrors, or null where nothing does
 */
public record EdgeCodes(int[] shapes, int[] lights, int[] mirroredShapes, int[] mirroredLights) {

    /** Where the two are alike, {@code known}, which may be null, so that who compares them later need not look inside. */
    public EdgeCodes reuseIfEqual(EdgeCodes known) {
        boolean isEqual = known != null && Arrays.equals(shapes, known.shapes) && Arrays.equals(lights, known.lights)
                && Arrays.equals(mirroredShapes, known.mirroredShapes) && Arrays.equals(mirroredLights, known.mirroredLights);
        return isEqual ? known : this;
    }

    /** The bytes of the arrays. */
    public long bytes() {
        return 4L * (shapes.length + lights.length + (mirroredShapes == null ? 0 : mirroredShapes.length + mirroredLights.length));
    }
}
