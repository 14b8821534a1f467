package lightning.cli;

import lightning.base.math.Rgb;
import lightning.render.shading.LightReport;
import lightning.render.shading.SurfaceShare;
import lightning.render.trace.SurfacePoint;
import lightning.scene.Material;

/** What each part of the equation adds to the colour of a point, for people: sums of them are rounded once more. */
record PointParts(SurfacePoint at, float[] kr, SurfaceShare shared) {

    static PointParts of(Material material, SurfacePoint at) {
        return new PointParts(at, floats(material.reflective()), new SurfaceShare(at));
    }

    /** kd·Idiff·(1 − kr) + (ks·Ispec + Igraz) of one light, linear, {@code float[3]}; of a clear surface what it has of that. */
    float[] of(LightReport light) {
        float[] added = new float[3];
        for (int c = 0; c < 3; c++) {
            added[c] = at.diffuse()[c] * light.diffuse()[c] * shared.body(kr[c], c)
                    + (at.specular()[c] * light.highlight()[c] + light.sheen()[c]) * shared.left(c);
        }
        return added;
    }

    /** What the mirrored ray adds, kr·Cr of an opaque surface, linear, {@code float[3]}. */
    float[] mirrored(float[] color) {
        return new float[] {shared.mirrored(kr[0], 0) * color[0], shared.mirrored(kr[1], 1) * color[1],
            shared.mirrored(kr[2], 2) * color[2]};
    }

    /** What the refracted ray adds, linear, {@code float[3]}. */
    float[] refracted(float[] color) {
        return new float[] {shared.refracted(kr[0], 0) * color[0], shared.refracted(kr[1], 1) * color[1],
            shared.refracted(kr[2], 2) * color[2]};
    }

    private static float[] floats(Rgb c) {
        return new float[] {(float) c.r(), (float) c.g(), (float) c.b()};
    }
}
