package lightning.render.shading.explanation;

import static java.util.Objects.requireNonNull;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Function;
import java.util.stream.IntStream;
import lightning.base.math.Ray;
import lightning.base.math.Vec3;
import lightning.render.fog.BounceRays;
import lightning.render.fog.FogMedium;
import lightning.render.gather.RowWeigher;
import lightning.render.shading.AreaSamples;
import lightning.render.shading.BackgroundShader;
import lightning.render.shading.Bsdf;
import lightning.render.shading.FilmEmission;
import lightning.render.shading.FilmPart;
import lightning.render.shading.FilmParts;
import lightning.render.shading.HighlightFactor;
import lightning.render.shading.IndirectLight;
import lightning.render.shading.LightSource;
import lightning.render.shading.LightWeight;
import lightning.render.shading.LightingEquation;
import lightning.render.shading.SurfaceFactors;
import lightning.render.shading.Transmittance;
import lightning.render.shading.WeightedLight;
import lightning.render.shading.fog.BounceFog;
import lightning.render.shading.fog.FogComposer;
import lightning.render.shading.fog.FogLookup;
import lightning.render.shading.fog.FogTile;
import lightning.render.shading.fog.PictureFog;
import lightning.render.trace.Geometry;
import lightning.render.trace.HitRows;
import lightning.render.trace.MaterialTable;
import lightning.render.trace.NormalSteps;
import lightning.render.trace.PixelRays;
import lightning.render.trace.SurfacePoint;
import lightning.render.trace.tree.ShadowRayTarget;
import lightning.scene.Scene;
import lightning.scene.material.AlphaCutout;
import lightning.scene.value.Fog;
import org.jspecify.annotations.Nullable;

/** Traces single pixels and reports every part of their color. The color has the bits of the film's. */
public final class PixelExplainer {
    private static final float[] ZERO = {0, 0, 0};
    private static final float[] ONE = {1, 1, 1};

    private final Scene scene;
    private final Geometry geometry;
    private final MaterialTable materials;
    private final @Nullable Geometry uncutGeometry;
    private final FilmParts parts;
    /** Null without indirect light, as the weigher. */
    private final @Nullable IndirectLight indirect;
    private final @Nullable RowWeigher weigher;
    /** Null for reports without fog. */
    private final @Nullable PictureFog pictureFog;
    /** Null if no light is seen in fog along bounced rays. */
    private final @Nullable PictureFog bounceFog;

    /** Shadow ray targets by light position. */
    private final Map<Vec3, ShadowRayTarget> shadowRayTargets;

    /** Creates an explainer that also reports cutouts that rays passed; builds a second BVH for this. */
    public PixelExplainer(Scene scene) {
        this(scene, Geometry.of(scene), new HashMap<>(), withoutCutouts(scene), null, null, null);
    }

    /** @param known existing geometry that serves the scene, from its traced picture */
    public PixelExplainer(Scene scene, Geometry known) {
        this(scene, known.forScene(scene, known.castsReflections()), new HashMap<>(), null, null, null, null);
    }

    private PixelExplainer(Scene scene, Geometry geometry, Map<Vec3, ShadowRayTarget> ends, @Nullable Geometry uncut,
            @Nullable IndirectLight indirect, @Nullable PictureFog fog, @Nullable PictureFog bounced) {
        this.scene = scene;
        pictureFog = fog;
        bounceFog = bounced;
        this.geometry = geometry;
        this.shadowRayTargets = ends;
        materials = geometry.materials();
        this.uncutGeometry = uncut;
        this.indirect = indirect;
        weigher = indirect == null ? null : new RowWeigher(indirect.structure());
        parts = FilmParts.of(scene);
    }

    /** Returns an explainer of another scene that shares cached geometry with this one. */
    public PixelExplainer forScene(Scene other, Geometry known) {
        boolean isUnchanged = geometry.canServe(other);
        return new PixelExplainer(other, (isUnchanged ? geometry : known).forScene(other, known.castsReflections()),
                isUnchanged ? shadowRayTargets : new HashMap<>(), null, null, null, null);
    }

    /** Returns this explainer with the indirect light of its scene; null for none, as initially. */
    public PixelExplainer withIndirect(@Nullable IndirectLight light) {
        return light == indirect ? this
                : new PixelExplainer(scene, geometry, shadowRayTargets, uncutGeometry, light, pictureFog, bounceFog);
    }

    /**
     * Returns this explainer with the fog of its scene's picture.
     *
     * @param fog     fog along camera rays; null for reports without fog, as initially
     * @param bounced fog along bounced rays; null if no light is seen there
     */
    public PixelExplainer withFog(@Nullable PictureFog fog, @Nullable PictureFog bounced) {
        return new PixelExplainer(scene, geometry, shadowRayTargets, uncutGeometry, indirect, fog, bounced);
    }

    /** Returns this explainer with a report of the cutouts that rays passed; builds a second BVH if the scene has any. */
    public PixelExplainer withPassedCutouts() {
        return uncutGeometry == null ? new PixelExplainer(scene, geometry, shadowRayTargets, withoutCutouts(scene), indirect, pictureFog,
                bounceFog)
                : this;
    }

    /** Returns the indirect light of the scene; null for none. */
    public @Nullable IndirectLight indirect() {
        return indirect;
    }

    /** Returns the shapes and materials that reports refer to. */
    public Geometry geometry() {
        return geometry;
    }

    /** Explains the pixel in column {@code x} from the left and row {@code y} from the top. */
    public PointReport explainPixel(int x, int y) {
        Ray ray = new PixelRays(scene).ray(x, y);
        PointReport report = explainRay(ray, scene.picture().depth(), new BouncePlace(x + 0.5, y + 0.5, 0));
        if (pictureFog == null) {
            return report;
        }
        FogTile tile = new FogLookup(pictureFog, parts.lights()).point(x + 0.5, y + 0.5, distance(report, ray.origin()));
        float[] scattered = new float[parts.lights().length];
        for (int l = 0; l < scattered.length; l++) {
            float[] column = tile.scattered()[l];
            scattered[l] = column == null ? 0 : column[0];
        }
        return behindFog(report, tile.transmittance()[0], scattered);
    }

    /**
     * Place in the image of a surface from which rays bounce that show light in fog.
     *
     * @param x           image coordinates, pixels, as {@code y}
     * @param refractions number of refractions before the surface
     */
    private record BouncePlace(double x, double y, int refractions) {
        /** Returns that of the surface behind this one. */
        BouncePlace behind() {
            return new BouncePlace(x, y, refractions + 1);
        }
    }

    /** @param place place of the surface that the ray hits; null if rays that bounce from there show no light in fog */
    private PointReport explainRay(Ray ray, int depth, @Nullable BouncePlace place) {
        int shape = geometry.nearest(ray);
        if (shape < 0) {
            float[][] background = new float[parts.count()][];
            Arrays.setAll(background, part -> BackgroundShader.color(parts, part, ray.direction()));
            return new PointReport(null, passedCutouts(ray, Double.POSITIVE_INFINITY), null, color(background), background, ZERO, ZERO,
                    null, null, List.of(), null, null, null);
        }
        SurfacePoint hit = geometry.surface(shape, ray);
        NormalSteps normals = geometry.normalSteps(shape, ray);
        PointReport reflected = materials.isReflective(hit.material()) && depth > 0
                ? explainBounce(hit.reflectedRay(materials.material(hit.material())), depth - 1,
                        materials.isClear(hit.material()) && requireNonNull(hit.backSide()).isInside(), null,
                        place != null && place.refractions == 0 ? light(place, BounceRays.MIRRORED, hit.material()) : null)
                : null;
        Ray through = materials.isClear(hit.material()) && depth > 0 ? hit.refractedRay() : null;
        PointReport refracted = through == null ? null
                : explainBounce(through, depth - 1, !hit.isInAirBehind(), place == null ? null : place.behind(),
                        place == null ? null : light(place, place.refractions + 1, hit.material()));
        List<LightReport> reports = new ArrayList<>();
        for (WeightedLight light : parts.lights()) {
            reports.add(lightReport(light, hit, normals));
        }
        SurfaceFactors factors = new SurfaceFactors(hit, materials.material(hit.material()));
        float[][] films = new float[parts.count()][3];
        // A point that receives nothing has black indirect light.
        float[] gathered = indirect == null ? null : new float[indirect.structure().reflections() == null ? 3 : 9];
        for (int part = 0; part < films.length; part++) {
            FilmPart its = parts.get(part);
            if (its.isDark()) {
                continue;
            }
            float[] light = indirect == null || weigher == null ? null : indirect.at(hit, weigher, part);
            if (gathered != null) {
                add(light, its.weight(), gathered);
            }
            for (int c = 0; c < 3; c++) {
                List<LightReport> own = reports.subList(its.from(), its.to());
                films[part][c] = factors.lit(c, sum(own, c, LightReport::diffuse) + (light == null ? 0 : light[c]),
                        sum(own, c, LightReport::highlight), sum(own, c, LightReport::sheen));
                films[part][c] += reflected == null ? 0 : factors.mirrored(c, reflected.films()[part][c]);
                films[part][c] += refracted == null ? 0 : factors.refracted(c, refracted.films()[part][c]);
                films[part][c] += light == null || light.length == 3 ? 0 : factors.reflected(c, light[3 + c], light[6 + c]);
                films[part][c] += factors.emitted(c, emitted(hit, part, c));
            }
        }
        float[] ambient = new float[3];
        float[] glow = new float[3];
        for (int part = 0; part < films.length; part++) {
            FilmPart its = parts.get(part);
            for (int c = 0; c < 3; c++) {
                float emitted = factors.emitted(c, emitted(hit, part, c)) * its.weight().channel(c);
                ambient[c] += its.kind() == FilmPart.Kind.AMBIENCE ? emitted : 0;
                glow[c] += its.kind() == FilmPart.Kind.AMBIENCE ? 0 : emitted;
            }
        }
        List<LightReport> weighted = new ArrayList<>();
        for (int part = 0; part < films.length; part++) {
            for (LightReport report : reports.subList(parts.get(part).from(), parts.get(part).to())) {
                weighted.add(report.times(parts.get(part).weight()));
            }
        }
        boolean isReflecting = gathered != null && gathered.length > 3 && materials.material(hit.material()).isPrincipled();
        return new PointReport(hit, passedCutouts(ray, geometry.distance(shape, ray)), normals, color(films), films, ambient, glow,
                gathered == null ? null : Arrays.copyOf(gathered, 3), isReflecting ? Arrays.copyOfRange(gathered, 3, 9) : null, weighted,
                reflected, refracted, null);
    }

    /** Returns one channel of the light that a point emits in a film. */
    private float emitted(SurfacePoint hit, int part, int c) {
        FilmEmission emission = FilmEmission.of(materials, parts, part);
        float amount = emission.amount(hit.material(), c);
        float[] map = emission.isMapped() ? hit.maps().get(HitRows.ColumnGroup.GLOW_TEXEL) : null;
        return map == null ? amount : amount * map[c];
    }

    private static void add(float @Nullable [] light, LightWeight weight, float[] sum) {
        for (int i = 0; light != null && i < sum.length; i++) {
            sum[i] += weight.channel(i % 3) * light[i];
        }
    }

    /** Returns the sum of all films, times their weights. */
    private float[] color(float[][] films) {
        float[] color = new float[3];
        for (int c = 0; c < 3; c++) {
            float[] terms = new float[films.length];
            for (int part = 0; part < terms.length; part++) {
                terms[part] = parts.get(part).weight().channel(c) * films[part][c];
            }
            color[c] = LightingEquation.sum(terms, 0, terms.length);
        }
        return color;
    }

    /** Light in fog along a bounced ray with a length. */
    @FunctionalInterface
    private interface BounceLight {
        /** Returns the light of each lamp of weight 1. */
        float[] along(Ray ray, double length);
    }

    /** Returns the light that is seen along rays of a path from a material at a place of the image; null for none. */
    private @Nullable BounceLight light(BouncePlace place, int path, int material) {
        PictureFog bounced = bounceFog;
        return bounced == null ? null
                : (ray, length) -> BounceFog.scatteredAlong(bounced, ray, length, place.x, place.y, path, material,
                        parts.lights());
    }

    /**
     * Explains a reflected or refracted ray with the fog along it.
     *
     * @param place as in {@link #explainRay}
     * @param light light in the fog; null for none
     */
    private PointReport explainBounce(Ray ray, int depth, boolean isInside, @Nullable BouncePlace place, @Nullable BounceLight light) {
        PointReport report = explainRay(ray, depth, place);
        FogMedium medium = pictureFog == null || isInside ? null : pictureFog.medium();
        if (medium == null) {
            return report;
        }
        Vec3 o = ray.origin();
        Vec3 d = ray.direction();
        float passed = (float) FogMedium.transmittance(medium.depth(o.x(), o.y(), o.z(), d.x(), d.y(), d.z(), distance(report, o)));
        float[] scattered = light == null ? null : light.along(ray, distance(report, o));
        return behindFog(report, passed, scattered);
    }

    /** @param scattered light of each lamp of weight 1; null for none */
    private PointReport behindFog(PointReport report, float passed, float @Nullable [] scattered) {
        Fog fog = scene.world().fog();
        float[][] films = new float[parts.count()][3];
        float[][] added = new float[parts.count()][3];
        for (int part = 0; part < films.length; part++) {
            FilmPart its = parts.get(part);
            for (int c = 0; c < 3 && !its.isDark(); c++) {
                float sum = 0;
                for (int l = its.from(); scattered != null && l < its.to(); l++) {
                    sum += parts.lights()[l].fog().channel(c) * scattered[l];
                }
                float ambient = its.kind() == FilmPart.Kind.REST ? LightWeight.channel(fog.ambient(), c) : 0;
                films[part][c] = FogComposer.color(report.films()[part][c], passed, LightWeight.channel(fog.color(), c), ambient, sum);
                added[part][c] = FogComposer.color(0, passed, LightWeight.channel(fog.color(), c), ambient, sum);
            }
        }
        return report.behind(new FogReport(passed, report.color(), color(added)), color(films), films);
    }

    private static double distance(PointReport report, Vec3 from) {
        SurfacePoint hit = report.hit();
        return hit == null ? Double.POSITIVE_INFINITY : new Vec3(hit.px(), hit.py(), hit.pz()).minus(from).length();
    }

    /** Returns the primitives that the ray would hit before a distance if nothing were cut out of them. */
    private List<Integer> passedCutouts(Ray ray, double before) {
        return uncutGeometry == null ? List.of() : IntStream.range(0, uncutGeometry.primitiveCount())
                .filter(s -> uncutGeometry.material(s).cutout() != geometry.material(s).cutout() && uncutGeometry.distance(s, ray) < before)
                .filter(s -> uncutGeometry.distance(s, ray) < geometry.distance(s, ray)).boxed().toList();
    }

    /** Returns the geometry without cutouts; null if the scene has none. */
    private static @Nullable Geometry withoutCutouts(Scene scene) {
        return scene.materials().stream().noneMatch(m -> m.cutout().isActive()) ? null : Geometry.of(
                scene.withMaterials(
                        scene.materials().stream().map(m -> m.cutout().isActive() ? m.withCutout(AlphaCutout.NONE) : m).toList()));
    }

    private static float sum(List<LightReport> lights, int channel, Function<LightReport, float[]> part) {
        float[] terms = new float[lights.size()];
        for (int l = 0; l < terms.length; l++) {
            terms[l] = part.apply(lights.get(l))[channel];
        }
        return LightingEquation.sum(terms, 0, terms.length);
    }

    private LightReport lightReport(WeightedLight light, SurfacePoint hit, @Nullable NormalSteps normals) {
        return light.source().isArea() && !light.isDark() ? areaReport(light, hit, normals)
                : lightReport(light, light.source(), HighlightFactor.NONE, hit, normals);
    }

    /** Returns the means of a light's samples. If no sample reaches the point, the state is that of the sample that passed most tests. */
    private LightReport areaReport(WeightedLight light, SurfacePoint hit, @Nullable NormalSteps normals) {
        AreaSamples area = requireNonNull(light.source().centerSamples());
        int samples = isPenumbra(light.source(), hit) ? area.refinedSamples() : area.samples();
        double diffuse = 0;
        double specular = 0;
        double grazing = 0;
        int visibleCount = 0;
        int below = 0;
        int rays = 0;
        LightReport best = null;
        LightReport blocked = null;
        double[] tints = new double[3];
        double[][] faces = new double[2][3];
        double shine = 0;
        int freeCount = 0;
        HighlightFactor factor = HighlightFactor.NONE;
        for (int s = 0; s < samples; s++) {
            if (s % area.samples() == 0) {
                factor = HighlightFactor.of(light.source(), area, AreaSamples.rotation(hit.px(), hit.py(), hit.pz()), s, hit,
                        materials.material(hit.material()));
            }
            LightReport one =
                    lightReport(light, sample(light.source(), hit, s), factor, hit, normals);
            // A visible sample counts even outside the cone, as in rows, whose shadow rays are not cast again when the cone moves. A surface has a
            // half-space that does not.
            LightSource sample = sample(light.source(), hit, s);
            boolean isBehind = light.source().type().isSurface() && one.state() == LightReport.State.OUTSIDE;
            if (s < area.samples() && one.state() != LightReport.State.AWAY && !isBehind
                    && (one.state() == LightReport.State.LIT || blocker(sample, hit) < 0)) {
                float[] passed = tint(sample, hit);
                for (int c = 0; c < 3; c++) {
                    tints[c] += passed[c];
                }
                freeCount++;
            }
            double diffuseTerm = (double) one.falloff() * (one.state() == LightReport.State.LIT ? one.cosine() : 0);
            double specularTerm = (double) one.specular() * one.falloff();
            double grazingTerm = (double) one.grazing() * one.falloff();
            diffuse += diffuseTerm;
            specular += specularTerm;
            grazing += grazingTerm;
            shine += specularTerm + grazingTerm;
            for (int c = 0; area.color != null && c < 3; c++) {
                float color = area.color[c][area.index(s, AreaSamples.rotation(hit.px(), hit.py(), hit.pz()))];
                faces[0][c] += diffuseTerm * color;
                faces[1][c] += (specularTerm + grazingTerm) * color;
            }
            visibleCount += one.state() == LightReport.State.LIT ? 1 : 0;
            below += one.samplesBelowSurface();
            rays += one.rays();
            best = best == null || one.state().compareTo(best.state()) > 0 ? one : best;
            blocked = blocked == null && one.state() == LightReport.State.SHADOWED ? one : blocked;
        }
        assert best != null;
        float cosine = LightingEquation.mean(diffuse, samples);
        float highlight = LightingEquation.mean(specular, samples);
        float sheen = LightingEquation.mean(grazing, samples);
        float[] tint =
                freeCount == 0 ? ONE : new float[] {LightingEquation.mean(tints[0], freeCount), LightingEquation.mean(tints[1], freeCount),
                    LightingEquation.mean(tints[2], freeCount)};
        float gain = light.gain(hit.primitive());
        float[] face = area.color == null ? ONE : weightedMeans(faces[0], diffuse);
        float[] diffuseFactor = product(tint, face);
        float[] specularFactor = area.color == null ? tint : product(tint, weightedMeans(faces[1], shine));
        return new LightReport(light.light(), best.state(), blocked == null ? -1 : blocked.blocker(), visibleCount, samples, rays, below,
                visibleCount == 0 ? best.cosine() : cosine, highlight, sheen, visibleCount == 0 ? 0 : 1,
                contribution(light.diffuse(), cosine, 1, diffuseFactor, gain),
                contribution(light.specular(), highlight, 1, specularFactor, gain),
                contribution(light.specular(), sheen, 1, specularFactor, gain), tint, face, gain);
    }

    private static float[] weightedMeans(double[] sums, double weight) {
        return new float[] {LightingEquation.weightedMean(sums[0], weight), LightingEquation.weightedMean(sums[1], weight),
            LightingEquation.weightedMean(sums[2], weight)};
    }

    private static float[] product(float[] a, float[] b) {
        return new float[] {a[0] * b[0], a[1] * b[1], a[2] * b[2]};
    }

    private LightReport lightReport(WeightedLight light, LightSource source, HighlightFactor factor, SurfacePoint hit,
            @Nullable NormalSteps normals) {
        var equation = new LightingEquation(source);
        equation.moveTo(hit.px(), hit.py(), hit.pz(), hit.nx(), hit.ny(), hit.nz());
        float cosine = equation.cosine(hit.nx(), hit.ny(), hit.nz());
        int below = cosine > 0 && normals != null && !light.isDark() && !(cosine(equation, normals.geometric()) > 0) ? 1 : 0;
        int blocker = -1;
        LightReport.State state;
        if (light.isDark()) {
            state = LightReport.State.DARK;
        } else if (!(cosine > 0)) {
            state = LightReport.State.AWAY;
        } else if (!equation.insideCone()) {
            state = LightReport.State.OUTSIDE;
        } else if (!geometry.linkedPrimitives(light.light().illuminates())[hit.primitive()]) {
            state = LightReport.State.UNLINKED;
        } else {
            blocker = blocker(source, hit);
            state = blocker < 0 ? LightReport.State.LIT : LightReport.State.SHADOWED;
        }
        if (state != LightReport.State.LIT) {
            return new LightReport(light.light(), state, blocker, 0, 1, state == LightReport.State.SHADOWED ? 1 : 0, below, cosine, 0, 0, 0,
                    ZERO, ZERO, ZERO, ONE, ONE,
                    light.gain(hit.primitive()));
        }
        Bsdf.Terms terms = Bsdf.of(materials.material(hit.material())).terms(equation, hit, cosine, factor);
        float diffuse = terms.diffuse();
        float specular = terms.specular();
        float grazing = terms.grazing();
        float falloff = equation.falloff();
        float[] tint = tint(source, hit);
        float gain = light.gain(hit.primitive());
        return new LightReport(light.light(), state, blocker, 1, 1, 1, below, diffuse, specular, grazing, falloff,
                contribution(light.diffuse(), diffuse, falloff, tint, gain), contribution(light.specular(), specular, falloff, tint, gain),
                contribution(light.specular(), grazing, falloff, tint, gain), tint, ONE, gain);
    }

    private static float cosine(LightingEquation equation, Vec3 normal) {
        return equation.cosine((float) normal.x(), (float) normal.y(), (float) normal.z());
    }

    private static float[] contribution(LightWeight weight, float term, float falloff, float[] tint, float gain) {
        return new float[] {
            LightingEquation.contribution(weight.red(), term, falloff, tint[0] * gain),
            LightingEquation.contribution(weight.green(), term, falloff, tint[1] * gain),
            LightingEquation.contribution(weight.blue(), term, falloff, tint[2] * gain)};
    }

    /** Returns the transmittance of an unblocked shadow ray: red, green and blue. */
    private float[] tint(LightSource source, SurfacePoint hit) {
        ShadowRayTarget target = source.type().hasPosition()
                ? shadowRayTargets.computeIfAbsent(source.position(), geometry::shadowRayTarget) : ShadowRayTarget.OFF_SURFACE;
        return Transmittance.ofShadowRay(geometry, source, target, hit);
    }

    /** Returns the shape between the point and the light that is nearest to the point, or −1. */
    private int blocker(LightSource source, SurfacePoint hit) {
        Vec3 point = new Vec3(hit.px(), hit.py(), hit.pz());
        Geometry casting = geometry.shadowGeometry(source.light().shadowCasters());
        if (!casting.castsShadows()) {
            return -1;
        }
        if (!source.type().hasPosition()) {
            return casting.nearest(new Ray(point, source.position()));
        }
        return casting.blocker(point, shadowRayTargets.computeIfAbsent(source.position(), geometry::shadowRayTarget));
    }

    /** Returns whether a point in the cone of an area light sees some of its first samples, and others that it faces are blocked. */
    private boolean isPenumbra(LightSource area, SurfacePoint hit) {
        boolean isSeen = false;
        boolean isBlocked = false;
        boolean isInside = false;
        for (int s = 0; s < requireNonNull(area.centerSamples()).samples(); s++) {
            LightSource sample = sample(area, hit, s);
            var equation = new LightingEquation(sample);
            equation.moveTo(hit.px(), hit.py(), hit.pz(), hit.nx(), hit.ny(), hit.nz());
            if (equation.cosine(hit.nx(), hit.ny(), hit.nz()) > 0 && (!area.type().isSurface() || equation.insideCone())) {
                boolean isFree = blocker(sample, hit) < 0;
                isSeen |= isFree;
                isBlocked |= !isFree;
                isInside |= equation.insideCone();
            }
        }
        return isSeen && isBlocked && isInside;
    }

    /** Returns a sample of an area light as a row of a pixel center uses it. */
    private static LightSource sample(LightSource area, SurfacePoint hit, int s) {
        return area.at(requireNonNull(area.centerSamples()), AreaSamples.rotation(hit.px(), hit.py(), hit.pz()), s);
    }
}
