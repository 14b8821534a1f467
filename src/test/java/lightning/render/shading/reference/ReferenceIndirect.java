package lightning.render.shading.reference;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Function;
import lightning.base.math.Vec3;
import lightning.render.gather.cell.CellKeys;
import lightning.render.gather.cell.DirectionCells;
import lightning.render.gather.cell.DirectionTable;
import lightning.render.gather.glow.GlowShapes;
import lightning.render.shading.FilmParts;
import lightning.render.shading.IndirectSolver;
import lightning.render.trace.Geometry;
import lightning.render.trace.HitRows.ColumnGroup;
import lightning.render.trace.MappedSurface;
import lightning.render.trace.MaterialTable;
import lightning.render.trace.PrincipledColors;
import lightning.render.trace.SurfacePoint;
import lightning.scene.GatherSettings;
import lightning.scene.Scene;
import lightning.scene.material.Material;

/**
 * Diffuse indirect light of a scene for {@link ReferenceTracer}: the oracle of {@link IndirectSolver} and of everything that it reads. It
 * shares with them only the formulas of cells, directions and weights.
 */
final class ReferenceIndirect {
    private final Scene scene;
    private final Geometry geometry;
    private final GatherSettings settings;
    private final CellKeys keys;
    /** Light of rays that leave the scene in each film: red, green, blue of each cell of directions, or of all. */
    private final float[][] background;
    /** Red, green and blue of all films. */
    private final int channels;
    private final int rest;
    private final GlowShapes glows;
    private final Function<SurfacePoint, float[]> directLight;
    private final List<Surfel> surfels = new ArrayList<>();
    /** Rays of the first surfels, without surfaces; further ones cast none. */
    private final List<List<ReferenceGatherRay>> surfelRays = new ArrayList<>();
    /** Light of each small glowing object at these surfels. */
    private final List<List<float[]>> surfelGlow = new ArrayList<>();
    private final Map<Long, Integer> surfelByCell = new HashMap<>();
    private final ReferencePointLight light;

    /**
     * Small part of a surface, lit at one place.
     *
     * @param texel  mean texture color of its cell: red, green, blue
     * @param mapped numbers of a principled material with the means of its maps
     * @param direct lights' diffuse sum: red, green, blue
     * @param glow   light that it emits itself: red, green, blue
     */
    private record Surfel(SurfacePoint at, float[] texel, MappedSurface mapped, float[] direct, float[] glow) {}

    /** @param directLight returns the lights' diffuse sum at a surface: red, green, blue of each film */
    ReferenceIndirect(FilmParts parts, Geometry geometry, GatherSettings settings, Function<SurfacePoint, float[]> directLight) {
        scene = parts.scene();
        channels = 3 * parts.count();
        rest = channels - 3;
        this.geometry = geometry;
        this.settings = settings;
        this.directLight = directLight;
        keys = new CellKeys(scene, settings);
        glows = settings.isIndirect() ? GlowShapes.of(geometry) : GlowShapes.none();
        background = new float[parts.count()][];
        Arrays.setAll(background, part -> parts.background(part).cells(settings.environment() ? DirectionCells.COUNT : 1));
        List<ReferenceGatherPoints.GatherPoint> points = new ReferenceGatherPoints(scene, geometry, keys, glows, settings).place();
        NewSurfels met = new NewSurfels();
        points.forEach(point -> met.add(point.rays()));
        met.createSurfels();
        int rounds = settings.isIndirect() && settings.environment() ? settings.bounces() + 1 : settings.bounces();
        for (int bounce = 2; bounce <= rounds; bounce++) {
            castSurfelRays();
        }
        light = new ReferencePointLight(points, points.stream().map(point -> point.rays().stream().map(this::target).toList()).toList(),
                geometry, gather(points));
    }

    /** Returns the place of the surfel that a ray hits; null for none. */
    private SurfacePoint target(ReferenceGatherRay ray) {
        return ray.isMiss() ? null : surfels.get(surfelByCell.get(ray.cell())).at();
    }

    /** Returns the indirect light at a surface that the picture shows: red, green, blue of each film. */
    float[] at(SurfacePoint hit) {
        float[] found = light.at(hit);
        return found.length == 0 ? new float[channels] : found;
    }

    /** Surfel of each new cell that some rays hit: the hit of the ray with the lowest rank. */
    private final class NewSurfels {
        private final Map<Long, Candidate> chosen = new HashMap<>();
        private int rays;

        private record Candidate(int number, ReferenceGatherRay ray) {}

        void add(List<ReferenceGatherRay> added) {
            for (ReferenceGatherRay ray : added) {
                if (!ray.isMiss() && !surfelByCell.containsKey(ray.cell())) {
                    chosen.merge(ray.cell(), new Candidate(rays, ray), (a, b) -> b.ray.rank() < a.ray.rank() ? b : a);
                }
                rays++;
            }
        }

        /** Adds the surfels in the order of their rays. */
        void createSurfels() {
            chosen.values().stream().sorted(Comparator.comparingInt(Candidate::number)).forEach(candidate -> addSurfel(candidate.ray));
        }
    }

    private void addSurfel(ReferenceGatherRay ray) {
        MaterialTable materials = geometry.materials();
        int material = ray.hit().material();
        float[] glow = new float[channels];
        float[] glowMap = ray.maps().get(ColumnGroup.GLOW_TEXEL);
        for (int c = 0; c < 3; c++) {
            float emitted = (1 - materials.reflective(material, c)) * materials.ownGlow(material, c);
            glow[rest + c] = glowMap == null ? emitted : emitted * glowMap[c];
        }
        surfelByCell.put(ray.cell(), surfels.size());
        var mapped = new MappedSurface();
        mapped.moveTo(materials.material(material), ray.maps());
        surfels.add(new Surfel(ray.hit(), ray.texel(), mapped, directLight.apply(ray.hit()), glow));
    }

    /** Returns one channel of the share that a surfel sends back. */
    private float albedo(Surfel surfel, int c) {
        int material = surfel.at().material();
        MaterialTable materials = geometry.materials();
        return materials.material(material).isPrincipled() ? principledAlbedo(surfel, materials.material(material), c)
                : (1 - materials.reflective(material, c)) * materials.diffuse(material, c) * surfel.texel()[c];
    }

    private float principledAlbedo(Surfel surfel, Material material, int c) {
        var colors = new PrincipledColors(material);
        float kd = colors.diffuse(c, surfel.mapped()) * surfel.texel()[c];
        float f0 = colors.f0(c, surfel.mapped(), surfel.texel()[c]);
        return ReferenceSheen.albedo(material, surfel.mapped(), c,
                kd * (1 - meanFresnel(surfel.mapped().largestNonmetalF0())) + meanFresnel(f0));
    }

    private static float meanFresnel(float f0) {
        return f0 + (1 - f0) / 21;
    }

    /** Casts the rays of all surfels that have none, then adds a surfel for each new cell that they hit. */
    private void castSurfelRays() {
        DirectionTable directions = new DirectionTable(settings.surfelRaysPerSide());
        NewSurfels met = new NewSurfels();
        for (Surfel surfel : surfels.subList(surfelRays.size(), surfels.size())) {
            SurfacePoint at = surfel.at();
            long seed = keys.surfelSeed(at.px(), at.py(), at.pz(), at.nx(), at.ny(), at.nz());
            List<ReferenceGatherRay> rays = ReferenceGatherRay.cast(geometry, keys, glows, directions, seed, 0, at);
            met.add(rays);
            // A scene with millions of rays fits into memory without their surfaces.
            surfelRays.add(rays.stream().map(ReferenceGatherRay::withoutSurface).toList());
            surfelGlow.add(new ReferenceGlow(geometry, keys, glows, directions.rays()).at(at, seed));
        }
        met.createSurfels();
    }

    /** Returns the light at each point: red, green, blue. */
    private float[][] gather(List<ReferenceGatherPoints.GatherPoint> points) {
        float[][] gathered = new float[points.size()][channels];
        List<Map<Integer, List<ReferenceGatherRay>>> rims = rims(points);
        for (int c = 0; c < channels; c++) {
            float[] scattered = scattered(c);
            int channel = c;
            for (int p = 0; p < points.size(); p++) {
                float[] value = {light(points.get(p).rays(), List.of(), scattered, c)};
                List<ReferenceGatherRay> own = points.get(p).rays();
                rims.get(p).forEach((cell, added) -> value[0] += rimChange(own, cell, added, scattered, channel));
                for (float[] object : points.get(p).glow()) {
                    value[0] += c < rest ? 0 : object[c - rest];
                }
                gathered[p][c] = value[0];
            }
        }
        return gathered;
    }

    /** Returns the additional rays of each point. */
    private List<Map<Integer, List<ReferenceGatherRay>>> rims(List<ReferenceGatherPoints.GatherPoint> points) {
        ReferenceRims rims = new ReferenceRims(keys);
        points.forEach(point -> rims.add(point.at(), point.rays()));
        DirectionTable directions = new DirectionTable(settings.raysPerSide());
        return points.stream()
                .map(point -> settings.environment() ? rims.cast(point, geometry, glows, directions)
                        : Map.<Integer, List<ReferenceGatherRay>>of())
                .toList();
    }

    /** Returns what additional rays change in one channel of the light that a point's own rays meet. */
    private float rimChange(List<ReferenceGatherRay> own, int cell, List<ReferenceGatherRay> added, float[] scattered, int c) {
        float share = 1f / own.size();
        float sum = 0;
        for (ReferenceGatherRay ray : added) {
            ReferenceGatherRay met = ray;
            for (int i = 0; !ray.isMiss() && !surfelByCell.containsKey(met.cell()) && i <= own.size(); i++) {
                // Surfels exist only where other rays found them.
                met = own.get((cell + i) % own.size());
            }
            sum += light(met, scattered, c) * share * ray.tint()[c % 3];
        }
        return (sum - added.size() * (light(own.get(cell), scattered, c) * share * own.get(cell).tint()[c % 3])) / (added.size() + 1);
    }

    /** Returns one channel of the light that each surfel scatters. */
    private float[] scattered(int c) {
        float[] sent = new float[surfels.size()];
        for (int bounce = 1; bounce <= settings.bounces(); bounce++) {
            float[] before = sent;
            sent = new float[surfels.size()];
            for (int s = 0; s < sent.length; s++) {
                float met = s >= surfelRays.size() ? 0 : bounce > 1 ? light(surfelRays.get(s), surfelGlow.get(s), before, c)
                        : settings.environment() ? fromEnvironment(surfelRays.get(s), c) : 0;
                sent[s] = albedo(surfels.get(s), c % 3) * (surfels.get(s).direct()[c] + met);
            }
        }
        return sent;
    }

    /** Returns one channel of the mean light that rays meet, plus that of small glowing objects. */
    private float light(List<ReferenceGatherRay> rays, List<float[]> glow, float[] scattered, int c) {
        float share = 1f / rays.size();
        float sum = 0;
        for (ReferenceGatherRay ray : rays) {
            sum += light(ray, scattered, c) * share * ray.tint()[c % 3];
        }
        for (float[] object : glow) {
            sum += c < rest ? 0 : object[c - rest];
        }
        return sum;
    }

    /** Returns one channel of the light that a ray meets. */
    private float light(ReferenceGatherRay ray, float[] scattered, int c) {
        return ray.isMiss() ? background(ray, c) : sent(ray, scattered, c);
    }

    private float sent(ReferenceGatherRay ray, float[] scattered, int c) {
        if (!settings.isIndirect()) {
            return 0;
        }
        int surfel = surfelByCell.get(ray.cell());
        return ray.dark() ? scattered[surfel] : surfels.get(surfel).glow()[c] + scattered[surfel];
    }

    /** Returns one channel of the mean light that rays meet which leave the scene. */
    private float fromEnvironment(List<ReferenceGatherRay> rays, int c) {
        float share = 1f / rays.size();
        float sum = 0;
        for (ReferenceGatherRay ray : rays) {
            sum += ray.isMiss() ? background(ray, c) * share * ray.tint()[c % 3] : 0;
        }
        return sum;
    }

    private float background(ReferenceGatherRay ray, int c) {
        Vec3 d = ray.direction();
        return background[c / 3][3 * (settings.environment() ? DirectionCells.of(d.x(), d.y(), d.z()) : 0) + c % 3];
    }
}
