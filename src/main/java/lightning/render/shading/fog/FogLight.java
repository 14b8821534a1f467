package lightning.render.shading.fog;

import lightning.render.fog.FogGrid;
import lightning.render.fog.FogMedium;
import lightning.scene.light.Light;

/**
 * Light of one light source in the fog of a picture: which samples along the rays of the grid it reaches, and how much of it they scatter
 * toward the camera, for a weight of 1 and white fog. Compared by identity.
 *
 * @param light      light that it was computed for
 * @param medium     fog that it was computed for
 * @param anisotropy mean cosine of scattering
 * @param depths     distance of the first surface along each ray: {@code float[rays]}
 * @param visible    samples of each ray that see the light, the lowest bit for the first: {@code int[rays]}; must not be modified
 * @param parts      light of each sample of each ray: {@code float[rays × samples]}; must not be modified
 * @param shines     true for rays of which any sample has light
 */
public record FogLight(Light light, FogMedium medium, double anisotropy, float[] depths, int[] visible, float[] parts, boolean[] shines) {
    /** Bytes of a ray of the grid: its samples, which of them see the light, and whether any has light. */
    static final int BYTES_PER_RAY = Float.BYTES * FogGrid.SAMPLES + Integer.BYTES + 1;

    public FogLight(Light light, FogMedium medium, double anisotropy, float[] depths, int[] visible, float[] parts) {
        this(light, medium, anisotropy, depths, visible, parts, shines(visible.length, parts));
    }

    private static boolean[] shines(int rays, float[] parts) {
        boolean[] shines = new boolean[rays];
        for (int i = 0; i < parts.length; i++) {
            shines[i / FogGrid.SAMPLES] |= parts[i] != 0;
        }
        return shines;
    }

    /** Returns whether it was computed for the same arrays of depths. */
    public boolean hasDepths(float[] of) {
        return depths == of;
    }

    /** Returns whether any sample of a ray has light. */
    boolean shines(int ray) {
        return shines[ray];
    }

    /** Returns the bytes of the arrays. */
    public long bytes() {
        return 5L * visible.length + 4L * parts.length;
    }
}
