package lightning.render.shading.reference;

import java.util.ArrayList;
import java.util.Collection;
import java.util.Collections;
import java.util.IdentityHashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import lightning.base.math.Ray;
import lightning.render.gather.cell.CellKeys;
import lightning.render.gather.cell.DirectionTable;
import lightning.render.gather.glow.GlowShapes;
import lightning.render.image.Film;
import lightning.render.trace.BruteForce;
import lightning.render.trace.Geometry;
import lightning.render.trace.MaterialTable;
import lightning.render.trace.PixelRays;
import lightning.render.trace.SurfacePoint;
import lightning.scene.GatherSettings;
import lightning.scene.PictureSettings;
import lightning.scene.Scene;

/** Chooses the gather points of a scene for {@link ReferenceTracer}, one surface after the other. */
final class ReferenceGatherPoints {
    private static final int CANDIDATES_PER_SPACING = 4;
    private static final float RADIUS = 1.2f;
    private static final float ACCURACY = 0.2f;

    private final Scene scene;
    private final Geometry geometry;
    private final CellKeys keys;
    private final GlowShapes glows;
    private final GatherSettings settings;
    private final DirectionTable directions;
    private final List<SurfacePoint> candidates = new ArrayList<>();
    /** Candidates that become points, in order. */
    private final List<SurfacePoint> chosen = new ArrayList<>();
    private final Map<SurfacePoint, List<ReferenceGatherRay>> rays = new IdentityHashMap<>();
    /** Level of the largest cell of each point. */
    private final Map<SurfacePoint, Integer> firstLevel = new IdentityHashMap<>();
    /** Level of the smallest cell of each point. */
    private final Map<SurfacePoint, Integer> smallest = new IdentityHashMap<>();

    /**
     * Point at which light is gathered.
     *
     * @param at       its surface
     * @param seed     of the directions of its rays
     * @param rays     rays by which it gathers light
     * @param glow     light of each small glowing object there: red, green, blue
     * @param harmonic harmonic mean length of the rays
     * @param radius   distance at which its weight is 0, scene units
     * @param side     side of the largest cell there, scene units
     */
    record GatherPoint(SurfacePoint at, long seed, List<ReferenceGatherRay> rays, List<float[]> glow, float harmonic, float radius,
            float side) {}

    ReferenceGatherPoints(Scene scene, Geometry geometry, CellKeys keys, GlowShapes glows, GatherSettings settings) {
        this.glows = glows;
        this.scene = scene;
        this.geometry = geometry;
        this.keys = keys;
        this.settings = settings;
        directions = new DirectionTable(settings.raysPerSide());
    }

    /** Returns the points in order. */
    List<GatherPoint> place() {
        traceCandidates();
        Collection<SurfacePoint> active = candidates;
        for (int level = 0; level < CellKeys.LEVELS; level++) {
            active = divide(active, level);
        }
        return chosen.stream().map(this::point).toList();
    }

    private void traceCandidates() {
        PictureSettings picture = scene.picture();
        PixelRays pixels = new PixelRays(scene);
        int step = Math.max(1, (int) (settings.pixelSpacing(picture) / CANDIDATES_PER_SPACING));
        for (int y0 = 0; y0 < picture.height(); y0 += Film.TILE_SIZE) {
            for (int x0 = 0; x0 < picture.width(); x0 += Film.TILE_SIZE) {
                List<Ray> pixelRays = new ArrayList<>();
                for (int y = y0; y < Math.min(picture.height(), y0 + Film.TILE_SIZE); y += step) {
                    for (int x = x0; x < Math.min(picture.width(), x0 + Film.TILE_SIZE); x += step) {
                        pixelRays.add(pixels.ray(x, y));
                    }
                }
                traceLevel(pixelRays, picture.depth());
            }
        }
    }

    /** Adds what some rays hit, then what the reflected rays hit and all rays that follow, then the same for the refracted rays. */
    private void traceLevel(List<Ray> from, int depth) {
        MaterialTable materials = geometry.materials();
        List<Ray> reflected = new ArrayList<>();
        List<Ray> refracted = new ArrayList<>();
        for (Ray ray : from) {
            int primitive = BruteForce.nearest(geometry, ray);
            if (primitive >= 0) {
                SurfacePoint hit = BruteForce.surface(geometry, primitive, ray);
                candidates.add(hit);
                if (materials.isReflective(hit.material())) {
                    reflected.add(hit.reflectedRay(geometry.materials().material(hit.material())));
                }
                Ray through = materials.isClear(hit.material()) ? hit.refractedRay() : null;
                if (through != null) {
                    refracted.add(through);
                }
            }
        }
        if (depth > 0 && !from.isEmpty()) {
            traceLevel(reflected, depth - 1);
            traceLevel(refracted, depth - 1);
        }
    }

    /** Chooses the first candidate in each cell of a level; returns the candidates in the cells that must be divided. */
    private List<SurfacePoint> divide(Collection<SurfacePoint> active, int level) {
        Map<Long, List<SurfacePoint>> cells = new LinkedHashMap<>();
        active.forEach(candidate -> cells.computeIfAbsent(cell(candidate, level), _ -> new ArrayList<>()).add(candidate));
        Set<SurfacePoint> divided = Collections.newSetFromMap(new IdentityHashMap<>());
        cells.forEach((cell, members) -> {
            SurfacePoint first = members.getFirst();
            if (!rays.containsKey(first)) {
                chosen.add(first);
                firstLevel.put(first, level);
                rays.put(first, ReferenceGatherRay.cast(geometry, keys, glows, directions, seed(first, level), 0, first));
            }
            smallest.put(first, level);
            if (ACCURACY * ReferenceGatherRay.harmonicMean(rays.get(first), keys.side(first.px(), first.py(), first.pz(), 0))
                    < radius(first)) {
                divided.addAll(members);
            }
        });
        return active.stream().filter(divided::contains).toList();
    }

    private long cell(SurfacePoint at, int level) {
        return keys.pointKey(at.px(), at.py(), at.pz(), at.nx(), at.ny(), at.nz(), at.primitive(), level);
    }

    private long seed(SurfacePoint at, int level) {
        return keys.pointSeed(at.px(), at.py(), at.pz(), at.nx(), at.ny(), at.nz(), level);
    }

    private float radius(SurfacePoint at) {
        return RADIUS * side(at, smallest.get(at));
    }

    private float side(SurfacePoint at, int level) {
        return (float) keys.side(at.px(), at.py(), at.pz(), level);
    }

    private GatherPoint point(SurfacePoint at) {
        long seed = seed(at, firstLevel.get(at));
        return new GatherPoint(at, seed, rays.get(at), new ReferenceGlow(geometry, keys, glows, settings.rays()).at(at, seed),
                ReferenceGatherRay.harmonicMean(rays.get(at), keys.side(at.px(), at.py(), at.pz(), 0)),
                radius(at), side(at, 0));
    }
}
