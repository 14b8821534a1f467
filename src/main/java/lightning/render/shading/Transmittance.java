package lightning.render.shading;

import java.util.IdentityHashMap;
import java.util.Map;
import lightning.base.math.Ray;
import lightning.base.math.Vec3;
import lightning.render.trace.Geometry;
import lightning.render.trace.Refraction;
import lightning.render.trace.SurfacePoint;
import lightning.render.trace.primitive.PrimitiveTable;
import lightning.render.trace.primitive.ShadowRayHits;
import lightning.render.trace.primitive.SurfaceHit;
import lightning.render.trace.tree.ShadowRayTarget;
import lightning.scene.Material;
import lightning.scene.Transmission;

/**
 * Transmittance of clear shapes along a straight shadow ray, without refraction. Each surface passes the share of a refracted ray,
 * (1 − m)·kt, by the angle from outside; each path inside multiplies T. Holds scratch memory: use one instance per thread.
 */
final class Transmittance {
    private final SurfaceHit surface = new SurfaceHit();
    private final float[] tint = new float[3];
    /** Interior tints of the materials met so far. */
    private final Map<Transmission, InteriorTint> interiors = new IdentityHashMap<>();
    /** Red, green, blue, 0…1. */
    final float[] rgb = new float[3];

    /**
     * Returns the transmittance of an unblocked shadow ray: red, green and blue.
     *
     * @param target target of the shadow ray; unread if the light has no position
     */
    static float[] ofShadowRay(Geometry geometry, LightSource source, ShadowRayTarget target, SurfacePoint hit) {
        boolean hasTarget = source.type().hasPosition();
        Vec3 point = new Vec3(hit.px(), hit.py(), hit.pz());
        Vec3 toTarget = hasTarget ? source.position().minus(point) : source.position();
        var crossings = new ShadowRayHits(1);
        geometry.shadowGeometry(source.light().shadowedBy()).collectHitsBruteForce(new Ray(point, toTarget),
                hasTarget ? target : ShadowRayTarget.OFF_SURFACE,
                hasTarget ? 1 : Double.POSITIVE_INFINITY, crossings);
        var transmittance = new Transmittance();
        transmittance.compute(geometry.primitives(), crossings, 0, point.x(), point.y(), point.z(), toTarget.x(), toTarget.y(),
                toTarget.z(), hasTarget);
        return transmittance.rgb;
    }

    /**
     * Computes {@link #rgb}; returns whether any channel is not 1.
     *
     * @param crossings hits of the shadow rays with clear shapes
     * @param rayState  index of the ray
     * @param ox        origin, with {@code oy} and {@code oz}
     * @param dx        direction of any length, with {@code dy} and {@code dz}
     * @param hasTarget true if the ray ends at distance 1; otherwise it has no end
     */
    boolean compute(PrimitiveTable primitives, ShadowRayHits crossings, int rayState, double ox, double oy, double oz, double dx, double dy,
            double dz,
            boolean hasTarget) {
        rgb[0] = 1;
        rgb[1] = 1;
        rgb[2] = 1;
        double length = Math.sqrt(dx * dx + dy * dy + dz * dz);
        float vx = (float) (dx / length);
        float vy = (float) (dy / length);
        float vz = (float) (dz / length);
        double last = 0;
        Transmission entered = null;
        for (int i = crossings.first(rayState); i != ShadowRayHits.END; i = crossings.next(i)) {
            double t = crossings.t[i];
            Material material = primitives.shadowTint(crossings.primitive[i]);
            Transmission clarity = material.transmission();
            surface.computeNormal(primitives, crossings.primitive[i], crossings.part[i], ox, oy, oz, dx, dy, dz, t);
            boolean isExit = surface.isInside() && !clarity.thin();
            interior(clarity).write(isExit ? (float) ((t - last) * length) : -1, tint);
            float share = Refraction.fresnelReflectance(clarity, false, surface.nx, surface.ny, surface.nz, vx, vy, vz);
            for (int c = 0; c < 3; c++) {
                rgb[c] *= LightingEquation.transmitted(ClearMaterialShader.channel(material.reflective(), c), share,
                        ClearMaterialShader.channel(clarity.color(), c))
                        * tint[c];
            }
            entered = surface.isInside() || clarity.thin() ? null : clarity;
            last = t;
        }
        if (hasTarget && entered != null) {
            interior(entered).write((float) ((1 - last) * length), tint);
            for (int c = 0; c < 3; c++) {
                rgb[c] *= tint[c];
            }
        }
        return rgb[0] != 1 || rgb[1] != 1 || rgb[2] != 1;
    }

    private InteriorTint interior(Transmission transmission) {
        InteriorTint known = interiors.get(transmission);
        if (known == null) {
            known = new InteriorTint(transmission);
            interiors.put(transmission, known);
        }
        return known;
    }
}
