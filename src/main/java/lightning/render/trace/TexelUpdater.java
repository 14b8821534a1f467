package lightning.render.trace;

import lightning.render.trace.tree.CandidateList;
import lightning.render.trace.tree.RayBeam;
import lightning.scene.Scene;

/**
 * Recomputes the texels of a tile's rows after a texture was changed, added or removed. Intersects each row's ray only with its
 * known shape. Holds scratch memory: use one per thread.
 */
public final class TexelUpdater {
    private final Geometry geometry;
    private final MaterialTable materials;
    private final CameraRays camera;
    private final Tracer tracer;
    private final TexelWriter texels;
    private final RayBeam beam = new RayBeam();
    private final CandidateList candidates = new CandidateList();
    private final RayColumns rays;
    /** Directions of all camera rays through the tile's sample positions. */
    private final RayColumns eyeRays;
    private final double[] direction = new double[3];
    private long rowsTouched;

    /** @param geometry geometry with the target materials */
    public TexelUpdater(Geometry geometry, Scene scene, Tracer tracer) {
        this.geometry = geometry;
        this.tracer = tracer;
        materials = geometry.materials();
        camera = new CameraRays(scene.camera(), scene.picture());
        rays = new RayColumns(camera);
        eyeRays = new RayColumns(camera);
        texels = new TexelWriter(geometry);
    }

    /** Returns the number of rows whose texels were written so far. */
    public long rowsTouched() {
        return rowsTouched;
    }

    /**
     * Returns the rows of a tile's first level with new texels.
     *
     * @param positions image positions of their rays
     * @param changed materials whose textures were changed, added or removed
     * @return the same object if nothing changes; all other columns are shared
     */
    public HitRows updateEyeRows(HitRows rows, SamplePositions positions, MaterialSet changed) {
        return updateTexels(rows, changed, () -> directEyeRays(positions), () -> {
            rays.startAsEyeRays(eyeRays);
            setEyeDirections(positions);
        });
    }

    /**
     * Returns the rows of a deeper level with new texels.
     *
     * @param parentRows rows of the previous level
     */
    public HitRows updateBounceRows(HitRows rows, HitRows parentRows, BounceKind bounce, MaterialSet changed) {
        return updateTexels(rows, changed, () -> {}, () -> {
            rays.startAtRows(parentRows, bounce);
            setBounceDirections(parentRows, bounce);
        });
    }

    private void directEyeRays(SamplePositions positions) {
        if (positions.pixels() == null) {
            eyeRays.startAtEye();
            tracer.directEyeRays(camera, positions.x0(), positions.y0(), SamplePositions.SIDE, SamplePositions.SIDE, eyeRays);
        } else {
            eyeRays.startAtSamples(positions, tracer);
        }
    }

    /**
     * @param prepare called once before the first run
     * @param direct directs the rays of a run, whose slots are set
     */
    private HitRows updateTexels(HitRows rows, MaterialSet changed, Runnable prepare, Runnable direct) {
        if (!changed.intersects(rows)) {
            return rows;
        }
        TexelColumns needed = TexelColumns.of(materials, rows);
        if (needed.isNone()) {
            return rows.texels().isNone() ? rows : rows.withCopiedTexels(needed);
        }
        prepare.run();
        HitRows updated = rows.withCopiedTexels(needed);
        for (int r = 0; r < rows.runCount; r++) {
            int material = rows.runMaterial[r];
            if (changed.contains(material) && !materials.texels(material).isNone()) {
                updateRun(updated, r, direct);
            }
        }
        return updated;
    }

    private void updateRun(HitRows rows, int run, Runnable direct) {
        int start = rows.runStart(run);
        rays.count = rows.runEnd[run] - start;
        rays.hitCount = rays.count;
        rowsTouched += rays.count;
        for (int i = 0; i < rays.count; i++) {
            rays.slot[i] = rows.parent[start + i];
            rays.order[i] = (short) i;
        }
        direct.run();
        candidates.collect(geometry.bvh(), beam);
        // A row's hit is the nearest of all shapes, and therefore of those with its material.
        candidates.retainMaterial(geometry.primitives(), rows.runMaterial[run]);
        tracer.findNearest(rays, candidates);
        tracer.writeLocalPoints(rays);
        texels.write(rows, start, rays);
    }

    private void setEyeDirections(SamplePositions positions) {
        for (int i = 0; i < rays.count; i++) {
            rays.dx[i] = eyeRays.dx[rays.slot[i]];
            rays.dy[i] = eyeRays.dy[rays.slot[i]];
            rays.dz[i] = eyeRays.dz[rays.slot[i]];
        }
        rays.boundCameraRays(beam, positions, tracer);
    }

    private void setBounceDirections(HitRows parentRows, BounceKind bounce) {
        for (int i = 0; i < rays.count; i++) {
            bounce.writeDirection(parentRows, rays.slot[i], materials, direction);
            rays.dx[i] = direction[0];
            rays.dy[i] = direction[1];
            rays.dz[i] = direction[2];
        }
        rays.bound(beam, tracer);
    }
}
