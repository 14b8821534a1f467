package lightning.render.shading;

import lightning.base.math.Ray;
import lightning.base.math.Vec3;
import lightning.render.trace.Geometry;
import lightning.render.trace.Refraction;
import lightning.render.trace.SurfacePoint;
import lightning.render.trace.primitive.Crossings;
import lightning.render.trace.primitive.PrimitiveTable;
import lightning.render.trace.primitive.Surface;
import lightning.render.trace.tree.WayEnd;
import lightning.scene.Clarity;
import lightning.scene.Material;

/**
 * What is left of light that passes clear shapes on its straight way to a point, as if nothing bent it: at each surface the share that a ray
 * seen through it has, (1 − m)·kt, by the angle from outside, and T on each way inside. Holds scratch memory: one for each thread.
 */
final class Transmittance {
    private final Surface surface = new Surface();
    private final float[] tint = new float[3];
    /** Red, green, blue, 0…1. */
    final float[] rgb = new float[3];

    /**
     * What passes of a light on its free way to a point, red, green and blue.
     *
     * @param end where the way ends; unread where the light has no position
     */
    static float[] onWay(Geometry geometry, Lamp lamp, WayEnd end, SurfacePoint at) {
        boolean ends = lamp.type().hasPosition();
        Vec3 point = new Vec3(at.px(), at.py(), at.pz());
        Vec3 way = ends ? lamp.source().minus(point) : lamp.source();
        var met = new Crossings(1);
        geometry.casting(lamp.light().shadowedBy()).crossingsOfAll(new Ray(point, way), ends ? end : WayEnd.OPEN,
                ends ? 1 : Double.POSITIVE_INFINITY, met);
        var transmittance = new Transmittance();
        transmittance.of(geometry.primitives(), met, 0, point.x(), point.y(), point.z(), way.x(), way.y(), way.z(), ends);
        return transmittance.rgb;
    }

    /**
     * Computes {@link #rgb}; whether any of it is not 1.
     *
     * @param met  where ways meet what light passes
     * @param way  which of them
     * @param ox   where it begins; likewise {@code oy} and {@code oz}
     * @param dx   the way, of any length; likewise {@code dy} and {@code dz}
     * @param ends whether it leads to a point, at distance 1; else it has no end
     */
    boolean of(PrimitiveTable primitives, Crossings met, int way, double ox, double oy, double oz, double dx, double dy, double dz,
            boolean ends) {
        rgb[0] = 1;
        rgb[1] = 1;
        rgb[2] = 1;
        double length = Math.sqrt(dx * dx + dy * dy + dz * dz);
        float vx = (float) (dx / length);
        float vy = (float) (dy / length);
        float vz = (float) (dz / length);
        double last = 0;
        Clarity entered = null;
        for (int i = met.first(way); i != Crossings.NONE; i = met.next(i)) {
            double t = met.t[i];
            Material material = primitives.tint(met.primitive[i]);
            Clarity clarity = material.clarity();
            surface.face(primitives, met.primitive[i], met.part[i], ox, oy, oz, dx, dy, dz, t);
            boolean leaves = surface.isInside() && !clarity.thin();
            ClearSums.tint(clarity, leaves ? (float) ((t - last) * length) : -1, tint);
            float share = Refraction.mirrored(clarity, false, surface.nx, surface.ny, surface.nz, vx, vy, vz);
            for (int c = 0; c < 3; c++) {
                rgb[c] *= LightingEquation.passed(ClearSums.channel(material.reflective(), c), share, ClearSums.channel(clarity.clear(), c))
                        * tint[c];
            }
            entered = surface.isInside() || clarity.thin() ? null : clarity;
            last = t;
        }
        if (ends && entered != null) {
            ClearSums.tint(entered, (float) ((1 - last) * length), tint);
            for (int c = 0; c < 3; c++) {
                rgb[c] *= tint[c];
            }
        }
        return rgb[0] != 1 || rgb[1] != 1 || rgb[2] != 1;
    }
}
