package lightning.render.shading;

import static java.util.Objects.requireNonNull;

import lightning.base.math.Ray;
import lightning.base.math.Vec3;
import lightning.render.trace.Geometry;
import lightning.render.trace.Refraction;
import lightning.render.trace.SurfacePoint;
import lightning.render.trace.primitive.PrimitiveTable;
import lightning.render.trace.primitive.ShadowRayHits;
import lightning.render.trace.primitive.SurfaceHit;
import lightning.render.trace.tree.ShadowRayTarget;
import lightning.scene.material.Material;
import lightning.scene.material.Transmission;

/**
 * Transmittance of clear shapes along a straight shadow ray, without refraction. Each surface passes the share of a refracted ray,
 * (1 − m)·kt, by the angle from outside; each path inside multiplies T. The reference for {@link TransmittanceBatch}.
 */
public final class Transmittance {
    private Transmittance() {}

    /**
     * Returns the transmittance of an unblocked shadow ray: red, green and blue, 0…1.
     *
     * @param target target of the shadow ray; unread if the light has no position
     */
    public static float[] ofShadowRay(Geometry geometry, LightSource source, ShadowRayTarget target, SurfacePoint hit) {
        boolean hasTarget = source.type().hasPosition();
        Vec3 point = new Vec3(hit.px(), hit.py(), hit.pz());
        Ray ray = new Ray(point, hasTarget ? source.position().minus(point) : source.position());
        var crossings = new ShadowRayHits(1);
        geometry.shadowGeometry(source.light().shadowCasters()).collectHitsBruteForce(ray,
                hasTarget ? target : ShadowRayTarget.OFF_SURFACE, hasTarget ? 1 : Double.POSITIVE_INFINITY, crossings);
        return ofCrossings(geometry.primitives(), crossings, ray, hasTarget);
    }

    /**
     * @param crossings hits of the ray with clear shapes
     * @param hasTarget true if the ray ends at distance 1; otherwise it has no end
     */
    private static float[] ofCrossings(PrimitiveTable primitives, ShadowRayHits crossings, Ray ray, boolean hasTarget) {
        float[] rgb = {1, 1, 1};
        float[] tint = new float[3];
        SurfaceHit surface = new SurfaceHit();
        Vec3 from = ray.origin();
        double dx = ray.direction().x();
        double dy = ray.direction().y();
        double dz = ray.direction().z();
        double length = Math.sqrt(dx * dx + dy * dy + dz * dz);
        float vx = (float) (dx / length);
        float vy = (float) (dy / length);
        float vz = (float) (dz / length);
        double last = 0;
        Transmission entered = null;
        for (int i = crossings.first(0); i != ShadowRayHits.END; i = crossings.next(i)) {
            double t = crossings.t[i];
            Material material = requireNonNull(primitives.shadowTint(crossings.primitive[i]));
            Transmission clarity = material.transmission();
            surface.computeNormal(primitives, crossings.primitive[i], crossings.part[i], from.x(), from.y(), from.z(), dx, dy, dz, t);
            boolean isExit = surface.isInside() && !clarity.thin();
            new InteriorTint(clarity).write(isExit ? (float) ((t - last) * length) : -1, tint);
            float share = Refraction.fresnelReflectance(clarity, false, surface.nx, surface.ny, surface.nz, vx, vy, vz);
            for (int c = 0; c < 3; c++) {
                rgb[c] *= Refraction.transmitted(LightWeight.channel(material.reflective(), c), share,
                        LightWeight.channel(clarity.color(), c))
                        * tint[c];
            }
            entered = surface.isInside() || clarity.thin() ? null : clarity;
            last = t;
        }
        if (hasTarget && entered != null) {
            new InteriorTint(entered).write((float) ((1 - last) * length), tint);
            for (int c = 0; c < 3; c++) {
                rgb[c] *= tint[c];
            }
        }
        return rgb;
    }
}
