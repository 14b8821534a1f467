package lightning.cli;

import lightning.math.Rgb;
import lightning.scene.Material;
import lightning.shading.LightReport;
import lightning.trace.SurfacePoint;

/** What each part of the equation adds to the colour of a point, for people: sums of them are rounded once more. */
record PointParts(Material material, SurfacePoint at) {

    /** kd·Idiff·(1 − kr) + (ks·Ispec + Igraz) of one light, linear, {@code float[3]}. */
    float[] of(LightReport light) {
        float[] kr = floats(material.reflective());
        float[] added = new float[3];
        for (int c = 0; c < 3; c++) {
            added[c] = at.diffuse()[c] * light.diffuse()[c] * (1 - kr[c]) + (at.specular()[c] * light.highlight()[c] + light.sheen()[c]);
        }
        return added;
    }

    /** kr·Cr, linear, {@code float[3]}. */
    float[] mirrored(float[] color) {
        float[] kr = floats(material.reflective());
        return new float[] {kr[0] * color[0], kr[1] * color[1], kr[2] * color[2]};
    }

    private static float[] floats(Rgb c) {
        return new float[] {(float) c.r(), (float) c.g(), (float) c.b()};
    }
}
