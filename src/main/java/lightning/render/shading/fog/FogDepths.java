package lightning.render.shading.fog;

import lightning.base.math.Ray;
import lightning.base.math.Vec3;
import lightning.base.work.Progress;
import lightning.base.work.WorkerPool;
import lightning.render.fog.FogRay;
import lightning.render.fog.FogRays;
import lightning.render.trace.Geometry;
import lightning.render.trace.SurfacePoint;

/** Finds the first surface along rays, on all threads. */
public final class FogDepths {
    /** Rays of a task. */
    private static final int RAYS = 512;

    private FogDepths() {}

    /** Returns the distance of each ray's first surface, scene units, infinite for none: {@code float[rays]}. */
    public static float[] trace(FogRays rays, Geometry geometry, WorkerPool workers, Progress progress) {
        float[] depths = new float[rays.count()];
        workers.run((depths.length + RAYS - 1) / RAYS, (_, task) -> {
            FogRay line = new FogRay();
            for (int ray = task * RAYS; ray < Math.min(depths.length, (task + 1) * RAYS); ray++) {
                rays.set(ray, line);
                depths[ray] = depth(geometry, new Ray(new Vec3(line.ox, line.oy, line.oz), new Vec3(line.dx, line.dy, line.dz)));
            }
        }, progress.cancellationOnly());
        return depths;
    }

    private static float depth(Geometry geometry, Ray ray) {
        int primitive = geometry.nearest(ray);
        if (primitive < 0) {
            return Float.POSITIVE_INFINITY;
        }
        SurfacePoint at = geometry.surface(primitive, ray);
        return (float) new Vec3(at.px(), at.py(), at.pz()).minus(ray.origin()).length();
    }
}
