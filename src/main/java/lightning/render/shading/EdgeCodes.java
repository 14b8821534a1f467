package lightning.render.shading;

import java.util.Arrays;

/**
 * Per-pixel codes for edge detection at pixel centers: neighboring pixels with different codes have an edge between them. A pixel
 * that hits nothing has code 0. Arrays, {@code int[1024]} each, are never written after construction.
 *
 * @param shapes         codes of shapes and textures and of their mirror images; no light edit changes them
 * @param lights         codes of shadows, cones and highlights and of their mirror images
 * @param mirroredShapes the part of {@code shapes} from mirrors, or null if nothing mirrors
 * @param mirroredLights the part of {@code lights} from mirrors, or null if nothing mirrors
 */
public record EdgeCodes(int[] shapes, int[] lights, int[] mirroredShapes, int[] mirroredLights) {

    /** Returns {@code known}, which may be null, if both are equal, so that later comparisons can compare references. */
    public EdgeCodes reuseIfEqual(EdgeCodes known) {
        boolean isEqual = known != null && Arrays.equals(shapes, known.shapes) && Arrays.equals(lights, known.lights)
                && Arrays.equals(mirroredShapes, known.mirroredShapes) && Arrays.equals(mirroredLights, known.mirroredLights);
        return isEqual ? known : this;
    }

    /** Returns the bytes of the arrays. */
    public long bytes() {
        return 4L * (shapes.length + lights.length + (mirroredShapes == null ? 0 : mirroredShapes.length + mirroredLights.length));
    }
}
