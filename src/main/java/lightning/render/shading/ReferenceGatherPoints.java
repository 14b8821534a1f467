package lightning.render.shading;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import lightning.base.math.Ray;
import lightning.render.gather.CellKeys;
import lightning.render.gather.DirectionTable;
import lightning.render.gather.RaySeed;
import lightning.render.image.Film;
import lightning.render.trace.Geometry;
import lightning.render.trace.MaterialTable;
import lightning.render.trace.PixelRays;
import lightning.render.trace.SurfacePoint;
import lightning.scene.IndirectSettings;
import lightning.scene.PictureSettings;
import lightning.scene.Scene;

/** Chooses the gather points of a scene for {@link ReferenceTracer}, one surface after the other. */
final class ReferenceGatherPoints {
    private static final int CANDIDATES_PER_CELL = 4;
    private static final float RADIUS = 1.5f;
    private static final float ACCURACY = 0.25f;

    private final Scene scene;
    private final Geometry geometry;
    private final CellKeys keys;
    private final IndirectSettings settings;
    private final DirectionTable directions;
    private final List<SurfacePoint> candidates = new ArrayList<>();
    private final List<GatherPoint> points = new ArrayList<>();

    /**
     * Point at which light is gathered.
     *
     * @param at       its surface
     * @param rays     rays by which it gathers light
     * @param harmonic harmonic mean length of the rays
     * @param radius   distance at which its weight is 0, scene units
     * @param side     side of the largest cell there, scene units
     */
    record GatherPoint(SurfacePoint at, List<ReferenceGatherRay> rays, float harmonic, float radius, float side) {}

    ReferenceGatherPoints(Scene scene, Geometry geometry, CellKeys keys, IndirectSettings settings) {
        this.scene = scene;
        this.geometry = geometry;
        this.keys = keys;
        this.settings = settings;
        directions = new DirectionTable(settings.raysPerSide());
    }

    /** Returns the points in order. */
    List<GatherPoint> place() {
        traceCandidates();
        List<SurfacePoint> active = candidates;
        for (int level = 0; level < CellKeys.LEVELS; level++) {
            active = place(active, level);
        }
        return points;
    }

    private void traceCandidates() {
        PictureSettings picture = scene.picture();
        PixelRays pixels = new PixelRays(scene);
        int step = Math.max(1, settings.spacing() / CANDIDATES_PER_CELL);
        for (int y0 = 0; y0 < picture.height(); y0 += Film.TILE_SIZE) {
            for (int x0 = 0; x0 < picture.width(); x0 += Film.TILE_SIZE) {
                List<Ray> rays = new ArrayList<>();
                for (int y = y0; y < Math.min(picture.height(), y0 + Film.TILE_SIZE); y += step) {
                    for (int x = x0; x < Math.min(picture.width(), x0 + Film.TILE_SIZE); x += step) {
                        rays.add(pixels.ray(x, y));
                    }
                }
                traceLevel(rays, picture.depth());
            }
        }
    }

    /** Adds what some rays hit, then what the reflected rays hit and all rays that follow, then the same for the refracted rays. */
    private void traceLevel(List<Ray> rays, int depth) {
        MaterialTable materials = geometry.materials();
        List<Ray> reflected = new ArrayList<>();
        List<Ray> refracted = new ArrayList<>();
        for (Ray ray : rays) {
            int primitive = geometry.nearestBruteForce(ray);
            if (primitive >= 0) {
                SurfacePoint hit = geometry.surfaceBruteForce(primitive, ray);
                candidates.add(hit);
                if (materials.isReflective(hit.material())) {
                    reflected.add(hit.reflectedRay());
                }
                Ray through = materials.isTransparent(hit.material()) ? hit.refractedRay() : null;
                if (through != null) {
                    refracted.add(through);
                }
            }
        }
        if (depth > 0 && !rays.isEmpty()) {
            traceLevel(reflected, depth - 1);
            traceLevel(refracted, depth - 1);
        }
    }

    /** Adds the first candidate of each cell of a level; returns the candidates in the cells that must be divided. */
    private List<SurfacePoint> place(List<SurfacePoint> active, int level) {
        Map<Long, SurfacePoint> firsts = new LinkedHashMap<>();
        for (SurfacePoint candidate : active) {
            firsts.putIfAbsent(cell(candidate, level), candidate);
        }
        Set<Long> divided = new HashSet<>();
        firsts.forEach((cell, first) -> {
            if (add(first, level)) {
                divided.add(cell);
            }
        });
        return active.stream().filter(candidate -> divided.contains(cell(candidate, level))).toList();
    }

    private long cell(SurfacePoint at, int level) {
        return keys.pointKey(at.px(), at.py(), at.pz(), at.nx(), at.ny(), at.nz(), at.primitive(), level);
    }

    /** Adds a point; returns whether its cell must be divided. */
    private boolean add(SurfacePoint at, int level) {
        List<ReferenceGatherRay> rays =
                ReferenceGatherRay.cast(geometry, keys, directions, RaySeed.ofPoint(at.px(), at.py(), at.pz(), level), at);
        float harmonic = ReferenceGatherRay.harmonicMean(rays, keys.side(at.px(), at.py(), at.pz(), 0));
        float cellSide = (float) keys.side(at.px(), at.py(), at.pz(), level);
        boolean divided = level + 1 < CellKeys.LEVELS && ACCURACY * harmonic < RADIUS * cellSide;
        points.add(new GatherPoint(at, rays, harmonic, RADIUS * (divided ? cellSide / 2 : cellSide),
                (float) keys.side(at.px(), at.py(), at.pz(), 0)));
        return divided;
    }
}
