package lightning.render.shading.reference;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import lightning.base.math.Ray;
import lightning.base.math.Vec3;
import lightning.render.image.Film;
import lightning.render.shading.AreaSamples;
import lightning.render.shading.BackgroundLight;
import lightning.render.shading.BackgroundShader;
import lightning.render.shading.EdgeColors;
import lightning.render.shading.EmittedLight;
import lightning.render.shading.HighlightFactor;
import lightning.render.shading.LightSource;
import lightning.render.shading.LightWeight;
import lightning.render.shading.LightingEquation;
import lightning.render.shading.PrincipledMaterial;
import lightning.render.shading.PrincipledWeights;
import lightning.render.shading.SampleMean;
import lightning.render.shading.SurfaceWeights;
import lightning.render.shading.Transmittance;
import lightning.render.shading.WeightedLight;
import lightning.render.shading.layer.LightRows;
import lightning.render.trace.BruteForce;
import lightning.render.trace.Geometry;
import lightning.render.trace.MaterialTable;
import lightning.render.trace.PixelRays;
import lightning.render.trace.SampleCells;
import lightning.render.trace.SamplePattern;
import lightning.render.trace.SurfacePoint;
import lightning.render.trace.tree.ShadowRayTarget;
import lightning.scene.GatherSettings;
import lightning.scene.PictureSettings;
import lightning.scene.Scene;
import lightning.scene.light.Light;
import lightning.scene.material.Material;
import lightning.scene.node.NodeGroup;

/**
 * Reference tracer: traces every pixel from the scene alone, ray by ray, as in §2.1 of the paper.
 *
 * <p>It tests each ray against every shape, caches nothing, and is slow. Every other renderer must match it in every bit.
 */
public final class ReferenceTracer {
    private static final int NO_PATTERN = -1;
    /** Indices of a light's terms ({@link #terms(SurfacePoint, int)}). */
    private static final int DIFFUSE = 0;
    private static final int SPECULAR = 1;
    private static final int GRAZING = 3;
    /** Red factors of the diffuse and of the other terms: tint, color of the light's image and gain; then green and blue. */
    private static final int DIFFUSE_FACTOR = 4;
    private static final int SPECULAR_FACTOR = 7;
    private static final int TERMS = 10;

    private final Scene scene;
    private final Geometry geometry;
    private final MaterialTable materials;
    private final WeightedLight[] lights;
    private final boolean forEdges;
    private final ShadowRayTarget[] targets;
    /** Shadow ray targets of area light samples. */
    private final Map<Vec3, ShadowRayTarget> sampleTargets = new HashMap<>();
    /** Geometry that casts the shadows of a light. */
    private final Map<Light, Geometry> casters = new IdentityHashMap<>();
    /** Whether a light illuminates each primitive. */
    private final Map<Light, boolean[]> linked = new IdentityHashMap<>();
    /** Gain of a light on each shape by its name. */
    private final Map<Light, Map<String, Float>> gains = new IdentityHashMap<>();
    private final ReferenceTracer mirrorTracer;
    /** Created on first use. */
    private ReferenceTracer edgeTracer;
    /** Computed on first use; null if the scene has none. */
    private ReferenceIndirect indirect;
    /** The same for scenes with blurred reflections. */
    private ReferenceReflections reflections;
    private ReferenceFog fog;
    private ReferenceBounceFog bounceFog;
    /** First samples of a pixel, and the further ones of some pixels. */
    private final SampleCells firstCells;
    private final SampleCells restCells;

    public ReferenceTracer(Scene scene) {
        this(scene, scene);
    }

    /**
     * Creates a tracer of {@code scene} whose mirrors show {@code mirrored}: the reference for outdated reflections (paper §4.8).
     * The two may differ in lights, world and materials.
     */
    public ReferenceTracer(Scene scene, Scene mirrored) {
        this(scene, mirrored, false);
    }

    /** @param forEdges true for the colors by which anti-aliasing decides ({@link EdgeColors}) */
    private ReferenceTracer(Scene scene, Scene mirrored, boolean forEdges) {
        this.scene = scene;
        this.forEdges = forEdges;
        mirrorTracer = scene == mirrored ? this : new ReferenceTracer(mirrored, mirrored, forEdges);
        geometry = Geometry.of(scene);
        materials = geometry.materials();
        lights = forEdges ? WeightedLight.forEdges(WeightedLight.ofScene(scene)) : WeightedLight.ofScene(scene);
        firstCells = SampleCells.first(scene.picture().sampling());
        restCells = SampleCells.rest(scene.picture().sampling());
        targets = Arrays.stream(lights).map(WeightedLight::source)
                .map(source -> source.type().hasPosition() ? geometry.shadowRayTargetBruteForce(source.position()) : null)
                .toArray(ShadowRayTarget[]::new);
    }

    /** Traces the whole picture. */
    public Film trace() {
        return trace(this);
    }

    /** Traces the whole picture with the sample positions of another picture of the same size. */
    public Film trace(ReferenceTracer sampled) {
        int width = scene.picture().width();
        int height = scene.picture().height();
        boolean[] fine = sampled.finePixels();
        ReferenceTracer edges = sampled.edgeTracer();
        float[] rgb = new float[3 * width * height];
        for (int y = 0; y < height; y++) {
            for (int x = 0; x < width; x++) {
                float[] color = fine[y * width + x] ? finePixel(x, y, sampled, edges) : pixel(x, y);
                System.arraycopy(color, 0, rgb, 3 * (y * width + x), 3);
            }
        }
        return Film.ofScanlines(width, height, rgb);
    }

    private ReferenceTracer edgeTracer() {
        if (edgeTracer == null) {
            edgeTracer = new ReferenceTracer(scene, mirrorTracer.scene, true);
        }
        return edgeTracer;
    }

    /** Returns the linear color at the center of one pixel, {@code float[3]}. */
    public float[] pixel(int x, int y) {
        return eyeColor(new PixelRays(scene).ray(x, y), x + 0.5, y + 0.5, NO_PATTERN);
    }

    /** Returns the mean of a pixel's samples: the first ones, and if their colors differ visibly, the rest. */
    private float[] finePixel(int x, int y, ReferenceTracer sampled, ReferenceTracer edges) {
        float[] first = mean(samples(x, y, sampled.firstCells));
        if (sampled.restCells.count() == 0 || !edges.differs(x, y, sampled.firstCells)) {
            return first;
        }
        float[] rest = mean(samples(x, y, sampled.restCells));
        float[] color = new float[3];
        for (int c = 0; c < 3; c++) {
            color[c] = SampleMean.combine(first[c], sampled.firstCells.count(), rest[c], sampled.restCells.count());
        }
        return color;
    }

    /** Returns whether the colors of some samples of a pixel differ visibly. */
    private boolean differs(int x, int y, SampleCells cells) {
        return EdgeColors.needMore(EdgeColors.pack(samples(x, y, cells)), 0, cells.count());
    }

    /** Returns the colors of some samples of a pixel: red, green and blue columns. */
    private float[][] samples(int x, int y, SampleCells cells) {
        float[][] samples = new float[3][cells.count()];
        for (int s = 0; s < cells.count(); s++) {
            int cell = cells.cells()[s];
            int pattern = SamplePattern.of(x, y, cells.part(s), cells.grid()) & 0xFF;
            float[] color = eyeColor(new PixelRays(scene).ray(x, y, cell, cells.grid()), x + offset(cell % cells.grid(), cells.grid()),
                    y + offset(cell / cells.grid(), cells.grid()), pattern);
            for (int c = 0; c < 3; c++) {
                samples[c][s] = color[c];
            }
        }
        return samples;
    }

    private static float[] mean(float[][] samples) {
        return new float[] {mean(samples[0]), mean(samples[1]), mean(samples[2])};
    }

    private static float mean(float[] samples) {
        float sum = LightingEquation.sum(samples, 0, samples.length);
        return Float.isFinite(sum) ? sum / samples.length : SampleMean.meanOfLarge(samples, 0, samples.length);
    }

    private static double offset(int cell, int grid) {
        return (2 * cell + 1) / (2.0 * grid);
    }

    /** Returns the color of a camera ray through a point of the image, in pixels, with the fog before it. Fog has no edges. */
    private float[] eyeColor(Ray ray, double x, double y, int pattern) {
        float[] color = color(ray, scene.picture().depth(), pattern, new BouncePlace(x, y, 0));
        if (forEdges || !scene.world().fog().isPresent()) {
            return color;
        }
        fog = fog == null ? new ReferenceFog(scene, lights, new AirVisibility()) : fog;
        int primitive = geometry.nearestBruteForce(ray);
        if (primitive < 0) {
            return fog.color(color, x, y, Double.POSITIVE_INFINITY);
        }
        SurfacePoint hit = BruteForce.surface(geometry, primitive, ray);
        return fog.color(color, x, y, fog.distance(hit.px(), hit.py(), hit.pz()));
    }

    /**
     * Place in the image of a surface, from which rays bounce that show light in fog.
     *
     * @param x           image coordinates, pixels, as {@code y}
     * @param refractions number of refractions before the surface
     */
    private record BouncePlace(double x, double y, int refractions) {}

    /**
     * Returns the color of a reflected or refracted ray with the fog along it.
     *
     * @param shown place whose bounced rays show light in fog, if this one does; null otherwise
     * @param path  number of refractions of this ray; 0 for a mirrored one
     * @param next  place of the surface that it hits; null if that has none
     * @param from  name of the material from which it bounces
     */
    private float[] bouncedColor(Ray ray, int depth, int pattern, boolean isInside, BouncePlace shown, int path, BouncePlace next,
            String from) {
        float[] color = color(ray, depth, pattern, next);
        if (forEdges || isInside || !scene.world().fog().isPresent()) {
            return color;
        }
        int primitive = geometry.nearestBruteForce(ray);
        double distance = Double.POSITIVE_INFINITY;
        if (primitive >= 0) {
            SurfacePoint hit = BruteForce.surface(geometry, primitive, ray);
            double dx = hit.px() - ray.origin().x();
            double dy = hit.py() - ray.origin().y();
            double dz = hit.pz() - ray.origin().z();
            distance = Math.sqrt(dx * dx + dy * dy + dz * dz);
        }
        bounceFog = bounceFog == null ? new ReferenceBounceFog(scene, lights, new AirVisibility()) : bounceFog;
        return bounceFog.color(ray, color, distance, shown == null ? null : new double[] {shown.x, shown.y}, path, from);
    }

    /** Visibility of lights from points in the air. */
    private final class AirVisibility implements ReferenceFog.Visibility {
        @Override
        public boolean isVisible(LightSource source, Vec3 point) {
            ShadowRayTarget target = sampleTarget(source);
            Geometry casting = geometry.shadowGeometry(source.light().shadowCasters());
            return source.type().hasPosition() ? !casting.isBlockedBruteForce(point, target)
                    : !casting.isBlockedBruteForce(new Ray(point, source.position()), Double.POSITIVE_INFINITY);
        }

        @Override
        public SurfacePoint surface(Ray ray) {
            int primitive = geometry.nearestBruteForce(ray);
            return primitive < 0 ? null : BruteForce.surface(geometry, primitive, ray);
        }

        @Override
        public Material material(SurfacePoint hit) {
            return materials.material(hit.material());
        }
    }

    /**
     * Returns the color of a ray; {@code depth} more bounces may be followed.
     *
     * @param pattern pattern of area light samples, or {@link #NO_PATTERN} for a pixel center
     * @param place   place of the surface in the image; null if rays that bounce from it show no light in fog
     */
    private float[] color(Ray ray, int depth, int pattern, BouncePlace place) {
        int primitive = geometry.nearestBruteForce(ray);
        if (primitive < 0) {
            return BackgroundShader.color(scene, ray.direction());
        }
        SurfacePoint hit = BruteForce.surface(geometry, primitive, ray);
        int material = hit.material();
        float[] mirrored = {0, 0, 0};
        if (materials.isReflective(material) && depth > 0) {
            mirrored = mirrorTracer.bouncedColor(hit.reflectedRay(materials.material(material)), depth - 1, pattern,
                    materials.isClear(material) && hit.backSide().isInside(),
                    place != null && place.refractions == 0 ? place : null, 0, null, materials.material(material).name());
        }
        Ray through = materials.isClear(material) && depth > 0 ? hit.refractedRay() : null;
        float[] refracted = new float[3];
        if (through != null) {
            boolean isInside = !hit.backSide().isInside() && !hit.backSide().transmission().thin();
            int path = place == null ? 0 : place.refractions + 1;
            refracted = mirrorTracer.bouncedColor(through, depth - 1, pattern, isInside, place, path,
                    place == null ? null : new BouncePlace(place.x, place.y, path), materials.material(material).name());
        }
        float[] color = new float[3];
        float[][] terms = terms(hit, pattern);
        float[] diffuse = diffuse(hit, terms);
        PrincipledMaterial principled = PrincipledMaterial.of(materials.material(material));
        boolean hasReflections = principled != null && GatherSettings.of(scene).map(GatherSettings::reflections).orElse(false);
        float[] light = hasReflections && !materials.isClear(material) ? reflections().at(hit) : new float[9];
        for (int c = 0; c < 3; c++) {
            float specular = sum(terms, SPECULAR, c);
            float grazing = sum(terms, GRAZING, c);
            color[c] = materials.isClear(material) ? clearColor(hit, c, diffuse[c], specular, grazing, mirrored, refracted)
                    : principled != null ? principledColor(hit, principled, c, diffuse[c], specular, grazing, mirrored[c], light)
                    : LightingEquation.color(emitted(hit, c), hit.diffuse()[c], diffuse[c],
                            hit.specular()[c], specular, grazing, materials.reflective(material, c), mirrored[c]);
            for (EmittedLight kind : EmittedLight.values()) {
                if (kind.isMapped(materials.texels(material))) {
                    float amount =
                            kind.amount(materials.ambient(material, c), (float) scene.world().ambience(), materials.glow(material, c));
                    color[c] = LightingEquation.addMapped(color[c], amount, hit.maps().get(kind.map().orElseThrow())[c],
                            new SurfaceWeights(hit).bodyWeight(materials.reflective(material, c), c));
                }
            }
        }
        return color;
    }

    private float emitted(SurfacePoint hit, int c) {
        int material = hit.material();
        return EmittedLight.unmapped(materials.texels(material), materials.ambient(material, c), (float) scene.world().ambience(),
                materials.glow(material, c));
    }

    /** Returns the lights' diffuse sum plus the indirect light: red, green, blue. */
    private float[] diffuse(SurfacePoint hit, float[][] terms) {
        float[] direct = {sum(terms, DIFFUSE, 0), sum(terms, DIFFUSE, 1), sum(terms, DIFFUSE, 2)};
        if (GatherSettings.of(scene).isEmpty()) {
            return direct;
        }
        if (GatherSettings.of(scene).get().reflections()) {
            float[] more = reflections().at(hit);
            return new float[] {direct[0] + more[0], direct[1] + more[1], direct[2] + more[2]};
        }
        indirect = indirect == null ? new ReferenceIndirect(scene, geometry, GatherSettings.of(scene).get(),
                forEdges ? BackgroundLight.of(scene).forEdges() : BackgroundLight.of(scene), this::directLight)
                : indirect;
        float[] more = indirect.at(hit);
        return new float[] {direct[0] + more[0], direct[1] + more[1], direct[2] + more[2]};
    }

    private ReferenceReflections reflections() {
        reflections = reflections == null ? new ReferenceReflections(scene, geometry, GatherSettings.of(scene).get(),
                forEdges ? BackgroundLight.of(scene).forEdges() : BackgroundLight.of(scene), this::directLight, this::shownLight)
                : reflections;
        return reflections;
    }

    /** Returns the lights' diffuse sum at a surface outside pixels: red, green, blue. */
    private float[] directLight(SurfacePoint hit) {
        float[][] terms = terms(hit, NO_PATTERN, false);
        return new float[] {sum(terms, DIFFUSE, 0), sum(terms, DIFFUSE, 1), sum(terms, DIFFUSE, 2)};
    }

    /** Returns the lights' diffuse and specular light that a picture shows of a surface outside pixels: red, green, blue. */
    private float[] shownLight(SurfacePoint hit) {
        float[][] terms = terms(hit, NO_PATTERN, false);
        PrincipledMaterial principled = PrincipledMaterial.of(materials.material(hit.material()));
        float[] color = new float[3];
        for (int c = 0; c < 3; c++) {
            float diffuse = sum(terms, DIFFUSE, c);
            float specular = sum(terms, SPECULAR, c);
            float grazing = sum(terms, GRAZING, c);
            color[c] = principled == null
                    ? LightingEquation.color(0, hit.diffuse()[c], diffuse, hit.specular()[c], specular, grazing,
                            materials.reflective(hit.material(), c), 0)
                    : weights(principled, hit).color(principled, c, 0, hit.diffuse()[c], diffuse, hit.specular()[c],
                            principled.colors().square(c, hit.mapped(principled.material()), hit.texel()[c]), specular, grazing, 0);
        }
        return color;
    }

    /** Returns one channel of the sum of a term over all lights. */
    private float sum(float[][] terms, int term, int c) {
        float[] contributions = new float[lights.length];
        for (int l = 0; l < lights.length; l++) {
            LightWeight weight = term == DIFFUSE ? lights[l].diffuse() : lights[l].specular();
            int factor = term == DIFFUSE ? DIFFUSE_FACTOR : SPECULAR_FACTOR;
            contributions[l] = LightingEquation.contribution(weight.channel(c), terms[l][term], terms[l][2], terms[l][factor + c]);
        }
        return LightingEquation.sum(contributions, 0, lights.length);
    }

    /** Returns one channel of the color of a clear surface. */
    private float clearColor(SurfacePoint hit, int c, float diffuse, float specular, float grazing, float[] mirrored,
            float[] refracted) {
        return new SurfaceWeights(hit).color(c, emitted(hit, c), hit.diffuse()[c], diffuse, hit.specular()[c], specular, grazing,
                materials.reflective(hit.material(), c), mirrored[c],
                refracted[c]);
    }

    /**
     * Returns for each light its diffuse and specular term, falloff, grazing term, and factors of diffuse and other terms at a point; all 0 if
     * it does not reach the point.
     */
    private float[][] terms(SurfacePoint hit, int pattern) {
        return terms(hit, pattern, true);
    }

    private float[][] terms(SurfacePoint hit, int pattern, boolean refines) {
        float[][] terms = new float[lights.length][TERMS];
        for (int l = 0; l < lights.length; l++) {
            LightSource source = lights[l].source();
            terms[l] = source.isArea() ? meanTerms(source, hit, pattern, refines) : terms(source, hit, targets[l], HighlightFactor.NONE);
            if (!source.light().contribution().gains().isNone()) {
                float gain = gains.computeIfAbsent(source.light(), _ -> new HashMap<>())
                        .computeIfAbsent(geometry.shape(hit.primitive()).name(), name -> gain(source.light(), name));
                for (int c = DIFFUSE_FACTOR; c < TERMS; c++) {
                    terms[l][c] *= gain;
                }
            }
        }
        return terms;
    }

    /** Returns the gain of a light on a shape: its own one, or that of the innermost group that has one. */
    private float gain(Light light, String shape) {
        List<String> names = new ArrayList<>(scene.stage().enclosingGroups(shape).stream().map(NodeGroup::name).toList());
        names.add(shape);
        return names.reversed().stream().flatMap(name -> light.contribution().gains().get(name).stream()).findFirst()
                .map(gain -> (float) light.limitedGain(gain)).map(gain -> forEdges ? LightWeight.nearestPowerOfTwo(gain) : gain).orElse(1f);
    }

    /** Returns the terms of a point light. */
    private float[] terms(LightSource source, SurfacePoint hit, ShadowRayTarget target, HighlightFactor factor) {
        LightingEquation equation = equation(source, hit);
        float cosine = equation.cosine(hit.nx(), hit.ny(), hit.nz());
        if (state(source, hit, target, equation, cosine) != LightRows.LIT) {
            return new float[TERMS];
        }
        float[] tint = Transmittance.ofShadowRay(geometry, source, target, hit);
        Material material = materials.material(hit.material());
        float specular = specular(equation, hit, factor);
        float grazing = grazing(equation, hit, factor);
        return new float[] {diffuse(equation, hit, cosine), ReferenceSheen.below(material, specular, grazing), equation.falloff(),
            ReferenceSheen.second(material, equation, hit, grazing), tint[0],
            tint[1], tint[2], tint[0], tint[1], tint[2]};
    }

    /** Returns the means over an area light's samples, falloff included. */
    private float[] meanTerms(LightSource source, SurfacePoint hit, int pattern, boolean refines) {
        AreaSamples area = pattern == NO_PATTERN ? source.centerSamples() : source.fineSamples();
        int used = pattern == NO_PATTERN ? AreaSamples.rotation(hit.px(), hit.py(), hit.pz()) : pattern;
        int samples = refines && isPenumbra(source, area, hit, used) ? area.refinedSamples() : area.samples();
        double diffuse = 0;
        double specular = 0;
        double grazing = 0;
        double[] tint = new double[3];
        double[] face = new double[3];
        double[] highlight = new double[3];
        double highlightWeight = 0;
        int freeCount = 0;
        for (int s = 0; s < samples; s++) {
            LightSource sample = source.at(area, used, s);
            // A visible sample counts even outside the cone, but not behind a surface. Further samples of a penumbra do not count.
            if (s < area.samples() && isBefore(sample, hit) && isVisible(sample, sampleTarget(sample), hit)) {
                float[] one = Transmittance.ofShadowRay(geometry, sample, sampleTarget(sample), hit);
                tint[0] += one[0];
                tint[1] += one[1];
                tint[2] += one[2];
                freeCount++;
            }
            float[] terms = terms(sample, hit, sampleTarget(sample),
                    HighlightFactor.of(source, area, used, s, hit, materials.material(hit.material())));
            diffuse += (double) terms[0] * terms[2];
            specular += (double) terms[1] * terms[2];
            grazing += (double) terms[3] * terms[2];
            double shine = (double) terms[1] * terms[2] + (double) terms[3] * terms[2];
            highlightWeight += shine;
            for (int c = 0; area.color != null && c < 3; c++) {
                face[c] += (double) terms[0] * terms[2] * area.color[c][area.index(s, used)];
                highlight[c] += shine * area.color[c][area.index(s, used)];
            }
        }
        float[] mean = new float[TERMS];
        mean[0] = LightingEquation.mean(diffuse, samples);
        mean[1] = LightingEquation.mean(specular, samples);
        mean[2] = 1;
        mean[3] = LightingEquation.mean(grazing, samples);
        for (int c = 0; c < 3; c++) {
            float tinted = LightingEquation.mean(tint[c], freeCount == 0 ? 1 : freeCount);
            mean[DIFFUSE_FACTOR + c] = area.color == null ? tinted : tinted * LightingEquation.weightedMean(face[c], diffuse);
            mean[SPECULAR_FACTOR + c] = area.color == null ? tinted : tinted * LightingEquation.weightedMean(highlight[c], highlightWeight);
        }
        return mean;
    }

    /** Returns whether a point in a light's cone sees some of its first samples, but not all before which it is. */
    private boolean isPenumbra(LightSource source, AreaSamples area, SurfacePoint hit, int pattern) {
        boolean isSeen = false;
        boolean isBlocked = false;
        boolean isInside = false;
        for (int s = 0; s < area.samples(); s++) {
            LightSource sample = source.at(area, pattern, s);
            if (isBefore(sample, hit)) {
                boolean visible = isVisible(sample, sampleTarget(sample), hit);
                isSeen |= visible;
                isBlocked |= !visible;
                isInside |= equation(sample, hit).insideCone();
            }
        }
        return isSeen && isBlocked && isInside;
    }

    /** Returns whether a point faces a sample and, if that is on a surface, is in its half-space. */
    private static boolean isBefore(LightSource sample, SurfacePoint hit) {
        LightingEquation equation = equation(sample, hit);
        return equation.cosine(hit.nx(), hit.ny(), hit.nz()) > 0 && (!sample.type().isSurface() || equation.insideCone());
    }

    private ShadowRayTarget sampleTarget(LightSource sample) {
        return sample.type().hasPosition() ? sampleTargets.computeIfAbsent(sample.position(), geometry::shadowRayTargetBruteForce) : null;
    }

    private static LightingEquation equation(LightSource source, SurfacePoint hit) {
        LightingEquation equation = new LightingEquation(source);
        equation.moveTo(hit.px(), hit.py(), hit.pz(), hit.nx(), hit.ny(), hit.nz());
        return equation;
    }

    private float diffuse(LightingEquation equation, SurfacePoint hit, float cosine) {
        return materials.isMetallic(hit.material()) && !materials.isPrincipled(hit.material())
                ? equation.metallicDiffuse(hit.nx(), hit.ny(), hit.nz(), hit.vx(), hit.vy(), hit.vz())
                : cosine;
    }

    private float grazing(LightingEquation equation, SurfacePoint hit, HighlightFactor factor) {
        if (!materials.isMetallic(hit.material())) {
            return 0;
        }
        PrincipledMaterial principled = PrincipledMaterial.of(materials.material(hit.material()));
        double surface = Material.alpha(hit.roughness());
        float grazing = principled == null || principled.highlight() == null
                ? equation.metallicGrazing(hit.nx(), hit.ny(), hit.nz(), hit.vx(), hit.vy(), hit.vz(), surface)
                : equation.anisotropicGrazing(hit.nx(), hit.ny(), hit.nz(), hit.vx(), hit.vy(), hit.vz(), hit.tangent(),
                        principled.highlight(), surface);
        grazing = factor.surface(grazing, surface);
        if (principled == null || principled.coat() == null) {
            return grazing;
        }
        double alpha = Material.alpha(hit.mapped(principled.material()).coatRoughness());
        float[] n = hit.coatNormal();
        boolean isLit = equation.cosine(n[0], n[1], n[2]) > 0;
        return weights(principled, hit).coatedGrazing(principled, grazing,
                factor.coat(isLit ? equation.metallicSpecular(n[0], n[1], n[2], hit.vx(), hit.vy(), hit.vz(), alpha) : 0, alpha),
                factor.coat(isLit ? equation.metallicGrazing(n[0], n[1], n[2], hit.vx(), hit.vy(), hit.vz(), alpha) : 0, alpha));
    }

    private static PrincipledWeights weights(PrincipledMaterial material, SurfacePoint hit) {
        PrincipledWeights weights = new PrincipledWeights();
        weights.moveTo(material, hit);
        return weights;
    }

    /** Returns one channel of the color of a principled surface. */
    private float principledColor(SurfacePoint hit, PrincipledMaterial material, int c, float diffuse, float specular, float grazing,
            float mirrored, float[] light) {
        PrincipledWeights weights = weights(material, hit);
        float shine = specular + light[3 + c] * weights.reflected(material);
        boolean isFrosted = material.material().isFrosted();
        float graze = grazing + light[isFrosted ? 3 + c : 6 + c] * weights.reflectedGrazing(material);
        if (material.isMirror()) {
            shine += mirrored * weights.mirrored(material);
            graze += mirrored * weights.mirroredGrazing(material);
        }
        return weights.color(material, c, emitted(hit, c), hit.diffuse()[c], diffuse, hit.specular()[c],
                material.colors().square(c, hit.mapped(material.material()), hit.texel()[c]),
                shine, graze,
                isFrosted ? weights.passing(material, c, light[6 + c]) : 0);
    }

    private float specular(LightingEquation equation, SurfacePoint hit, HighlightFactor factor) {
        if (materials.isMetallic(hit.material())) {
            PrincipledMaterial principled = PrincipledMaterial.of(materials.material(hit.material()));
            double alpha = Material.alpha(hit.roughness());
            float specular = principled == null || principled.highlight() == null
                    ? equation.metallicSpecular(hit.nx(), hit.ny(), hit.nz(), hit.vx(), hit.vy(), hit.vz(), alpha)
                    : equation.anisotropicSpecular(hit.nx(), hit.ny(), hit.nz(), hit.vx(), hit.vy(), hit.vz(), hit.tangent(),
                            principled.highlight(), alpha);
            specular = factor.surface(specular, alpha);
            return principled == null || principled.coat() == null ? specular : specular * weights(principled, hit).base();
        }
        return equation.specular(hit.nx(), hit.ny(), hit.nz(), hit.vx(), hit.vy(), hit.vz(), materials.shininess(hit.material()));
    }

    private int state(LightSource source, SurfacePoint hit, ShadowRayTarget target, LightingEquation equation, float cosine) {
        return !(cosine > 0) ? LightRows.FACING_AWAY
                : !equation.insideCone() || !isLinked(source, hit) ? LightRows.OUTSIDE_CONE
                : isVisible(source, target, hit) ? LightRows.LIT : LightRows.SHADOWED;
    }

    /** Returns whether a light illuminates the shape at a point. */
    private boolean isLinked(LightSource source, SurfacePoint hit) {
        return linked.computeIfAbsent(source.light(), light -> geometry.linkedPrimitives(light.illuminates()))[hit.primitive()];
    }

    /** Returns whether no shape that casts shadows from the light is between it and a point. */
    private boolean isVisible(LightSource source, ShadowRayTarget target, SurfacePoint hit) {
        Vec3 point = new Vec3(hit.px(), hit.py(), hit.pz());
        Geometry casting = casters.computeIfAbsent(source.light(), light -> geometry.shadowGeometry(light.shadowCasters()));
        return source.type().hasPosition()
                ? !casting.isBlockedBruteForce(point, target)
                : !casting.isBlockedBruteForce(new Ray(point, source.position()), Double.POSITIVE_INFINITY);
    }

    /** Returns the pixels that have several samples: {@code boolean[width * height]}, line by line. */
    private boolean[] finePixels() {
        PictureSettings picture = scene.picture();
        boolean[] fine = new boolean[picture.width() * picture.height()];
        switch (picture.sampling().antialias()) {
            case OFF -> Arrays.fill(fine, false);
            case EVERY -> Arrays.fill(fine, true);
            case EDGES -> {
                ReferenceTracer edges = edgeTracer();
                int[] colors = new int[fine.length];
                for (int i = 0; i < fine.length; i++) {
                    float[] color = edges.pixel(i % picture.width(), i / picture.width());
                    colors[i] = EdgeColors.pack(color[0], color[1], color[2]);
                }
                for (int i = 0; i < fine.length; i++) {
                    int x = i % picture.width();
                    fine[i] = x > 0 && EdgeColors.differ(colors[i], colors[i - 1])
                            || x + 1 < picture.width() && EdgeColors.differ(colors[i], colors[i + 1])
                            || i >= picture.width() && EdgeColors.differ(colors[i], colors[i - picture.width()])
                            || i + picture.width() < fine.length && EdgeColors.differ(colors[i], colors[i + picture.width()]);
                }
            }
        }
        return fine;
    }
}
