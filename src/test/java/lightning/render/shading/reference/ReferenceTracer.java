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
import lightning.render.shading.BackgroundShader;
import lightning.render.shading.Bsdf;
import lightning.render.shading.EdgeColors;
import lightning.render.shading.FilmPart;
import lightning.render.shading.FilmParts;
import lightning.render.shading.HighlightFactor;
import lightning.render.shading.LightSource;
import lightning.render.shading.LightWeight;
import lightning.render.shading.LightingEquation;
import lightning.render.shading.RenderedScenes;
import lightning.render.shading.SampleMean;
import lightning.render.shading.SurfaceFactors;
import lightning.render.shading.Transmittance;
import lightning.render.shading.WeightedLight;
import lightning.render.shading.layer.LightRows;
import lightning.render.trace.BruteForce;
import lightning.render.trace.Geometry;
import lightning.render.trace.HitRows;
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
    private final FilmParts parts;
    private final WeightedLight[] lights;
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
    /** Films of pixel centers that were traced: {@code float[channels]}. */
    private final Map<Integer, float[]> centers = new HashMap<>();
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
        this.scene = scene;
        mirrorTracer = new RenderedScenes(scene, mirrored).areReflectionsCurrent() ? this : new ReferenceTracer(mirrored, mirrored);
        geometry = Geometry.of(scene);
        materials = geometry.materials();
        parts = FilmParts.of(scene);
        lights = parts.lights();
        firstCells = SampleCells.first(scene);
        restCells = SampleCells.rest(scene);
        targets = Arrays.stream(lights).map(WeightedLight::source)
                .map(source -> source.type().hasPosition() ? BruteForce.shadowRayTarget(geometry, source.position()) : null)
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
        float[] rgb = new float[3 * width * height];
        for (int y = 0; y < height; y++) {
            for (int x = 0; x < width; x++) {
                float[] color = fine[y * width + x] ? finePixel(x, y, sampled) : pixel(x, y);
                System.arraycopy(color, 0, rgb, 3 * (y * width + x), 3);
            }
        }
        return Film.ofScanlines(width, height, rgb);
    }

    /** Returns the linear color at the center of one pixel, {@code float[3]}. */
    public float[] pixel(int x, int y) {
        return mix(center(x, y), parts.weights(), earlier(0));
    }

    /** Returns the color at the center of one pixel by which edges are found, {@code float[3]}. */
    private float[] edgePixel(int x, int y) {
        return mix(center(x, y), parts.edgeWeights(), earlier(1));
    }

    private float[] center(int x, int y) {
        return centers.computeIfAbsent(y * scene.picture().width() + x,
                _ -> eyeColor(new PixelRays(scene).ray(x, y), x + 0.5, y + 0.5, NO_PATTERN));
    }

    /** Returns the number of values of a color: red, green and blue of each film, then of what mirrors show of an earlier scene, and for edges. */
    private int channels() {
        return earlier(2);
    }

    /** Returns the first channel of what mirrors show of an earlier scene: 0 for colors, 1 for edges. */
    private int earlier(int kind) {
        return 3 * (parts.count() + kind);
    }

    /** Returns the sum of all films. */
    private float[] mix(float[] films, LightWeight[] weights, int earlier) {
        float[] color = mix(films, weights);
        for (int c = 0; c < 3; c++) {
            color[c] += films[earlier + c];
        }
        return color;
    }

    private static float[] mix(float[] films, LightWeight[] weights) {
        float[] color = new float[3];
        for (int c = 0; c < 3; c++) {
            float[] terms = new float[weights.length];
            for (int part = 0; part < terms.length; part++) {
                terms[part] = weights[part].channel(c) * films[3 * part + c];
            }
            color[c] = LightingEquation.sum(terms, 0, terms.length);
        }
        return color;
    }

    /** Returns the mean of a pixel's samples: the first ones, and if their colors differ visibly, the rest. */
    private float[] finePixel(int x, int y, ReferenceTracer sampled) {
        float[] mean = mean(samples(x, y, sampled.firstCells));
        if (sampled.restCells.count() > 0 && sampled.differs(x, y, sampled.firstCells)) {
            float[] rest = mean(samples(x, y, sampled.restCells));
            for (int c = 0; c < mean.length; c++) {
                mean[c] = SampleMean.combine(mean[c], sampled.firstCells.count(), rest[c], sampled.restCells.count());
            }
        }
        return mix(mean, parts.weights(), earlier(0));
    }

    /** Returns whether the colors of some samples of a pixel differ visibly. */
    private boolean differs(int x, int y, SampleCells cells) {
        float[][] samples = samples(x, y, cells);
        int[] packed = new int[cells.count()];
        for (int s = 0; s < packed.length; s++) {
            float[] films = new float[channels()];
            for (int c = 0; c < films.length; c++) {
                films[c] = samples[c][s];
            }
            float[] color = mix(films, parts.edgeWeights(), earlier(1));
            packed[s] = EdgeColors.pack(color[0], color[1], color[2]);
        }
        return EdgeColors.needMore(packed, 0, packed.length);
    }

    /** Returns the films of some samples of a pixel, by channel. */
    private float[][] samples(int x, int y, SampleCells cells) {
        float[][] samples = new float[channels()][cells.count()];
        for (int s = 0; s < cells.count(); s++) {
            int cell = cells.cells()[s];
            int pattern = SamplePattern.of(x, y, cells.part(s), cells.grid()) & 0xFF;
            float[] color = eyeColor(new PixelRays(scene).ray(x, y, cell, cells.grid()), x + offset(cell % cells.grid(), cells.grid()),
                    y + offset(cell / cells.grid(), cells.grid()), pattern);
            for (int c = 0; c < color.length; c++) {
                samples[c][s] = color[c];
            }
        }
        return samples;
    }

    private static float[] mean(float[][] samples) {
        float[] mean = new float[samples.length];
        for (int c = 0; c < mean.length; c++) {
            mean[c] = mean(samples[c]);
        }
        return mean;
    }

    private static float mean(float[] samples) {
        float sum = LightingEquation.sum(samples, 0, samples.length);
        return Float.isFinite(sum) ? sum / samples.length : SampleMean.meanOfLarge(samples, 0, samples.length);
    }

    private static double offset(int cell, int grid) {
        return (2 * cell + 1) / (2.0 * grid);
    }

    /** Returns the films of a camera ray through a point of the image, in pixels, with the fog before it. */
    private float[] eyeColor(Ray ray, double x, double y, int pattern) {
        float[] color = color(ray, scene.picture().depth(), pattern, new BouncePlace(x, y, 0));
        if (!scene.world().fog().isPresent()) {
            return color;
        }
        fog = fog == null ? new ReferenceFog(parts, new AirVisibility()) : fog;
        int primitive = BruteForce.nearest(geometry, ray);
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
     * Returns the films of a reflected or refracted ray with the fog along it.
     *
     * @param shown place whose bounced rays show light in fog, if this one does; null otherwise
     * @param path  number of refractions of this ray; 0 for a mirrored one
     * @param next  place of the surface that it hits; null if that has none
     * @param from  name of the material from which it bounces
     */
    private float[] bouncedColor(Ray ray, int depth, int pattern, boolean isInside, BouncePlace shown, int path, BouncePlace next,
            String from) {
        float[] color = color(ray, depth, pattern, next);
        if (isInside || !scene.world().fog().isPresent()) {
            return color;
        }
        int primitive = BruteForce.nearest(geometry, ray);
        double distance = Double.POSITIVE_INFINITY;
        if (primitive >= 0) {
            SurfacePoint hit = BruteForce.surface(geometry, primitive, ray);
            double dx = hit.px() - ray.origin().x();
            double dy = hit.py() - ray.origin().y();
            double dz = hit.pz() - ray.origin().z();
            distance = Math.sqrt(dx * dx + dy * dy + dz * dz);
        }
        bounceFog = bounceFog == null ? new ReferenceBounceFog(parts, new AirVisibility()) : bounceFog;
        return bounceFog.color(ray, color, distance, shown == null ? null : new double[] {shown.x, shown.y}, path, from);
    }

    /** Visibility of lights from points in the air. */
    private final class AirVisibility implements ReferenceFog.Visibility {
        @Override
        public boolean isVisible(LightSource source, Vec3 point) {
            ShadowRayTarget target = sampleTarget(source);
            Geometry casting = geometry.shadowGeometry(source.light().shadowCasters());
            return source.type().hasPosition() ? !BruteForce.isBlocked(casting, point, target)
                    : !BruteForce.isBlocked(casting, new Ray(point, source.position()), Double.POSITIVE_INFINITY);
        }

        @Override
        public SurfacePoint surface(Ray ray) {
            int primitive = BruteForce.nearest(geometry, ray);
            return primitive < 0 ? null : BruteForce.surface(geometry, primitive, ray);
        }

        @Override
        public Material material(SurfacePoint hit) {
            return materials.material(hit.material());
        }
    }

    /**
     * Returns the films of a ray; {@code depth} more bounces may be followed.
     *
     * @param pattern pattern of area light samples, or {@link #NO_PATTERN} for a pixel center
     * @param place   place of the surface in the image; null if rays that bounce from it show no light in fog
     */
    private float[] color(Ray ray, int depth, int pattern, BouncePlace place) {
        int primitive = BruteForce.nearest(geometry, ray);
        if (primitive < 0) {
            float[] background = new float[channels()];
            for (int part = 0; part < parts.count(); part++) {
                System.arraycopy(BackgroundShader.color(parts, part, ray.direction()), 0, background, 3 * part, 3);
            }
            return background;
        }
        SurfacePoint hit = BruteForce.surface(geometry, primitive, ray);
        int material = hit.material();
        float[] mirrored = new float[mirrorTracer.channels()];
        if (materials.isReflective(material) && depth > 0) {
            mirrored = mirrorTracer.bouncedColor(hit.reflectedRay(materials.material(material)), depth - 1, pattern,
                    materials.isClear(material) && hit.backSide().isInside(),
                    place != null && place.refractions == 0 ? place : null, 0, null, materials.material(material).name());
        }
        Ray through = materials.isClear(material) && depth > 0 ? hit.refractedRay() : null;
        float[] refracted = new float[mirrorTracer.channels()];
        if (through != null) {
            boolean isInside = !hit.backSide().isInside() && !hit.backSide().transmission().thin();
            int path = place == null ? 0 : place.refractions + 1;
            refracted = mirrorTracer.bouncedColor(through, depth - 1, pattern, isInside, place, path,
                    place == null ? null : new BouncePlace(place.x, place.y, path), materials.material(material).name());
        }
        float[] color = new float[channels()];
        float[][] terms = terms(hit, pattern);
        SurfaceFactors factors = new SurfaceFactors(hit, materials.material(material));
        boolean gathers = GatherSettings.of(scene).isPresent();
        boolean blurs = gathers && GatherSettings.of(scene).get().reflections() && materials.material(material).isPrincipled()
                && !materials.isClear(material);
        for (int part = 0; part < parts.count(); part++) {
            float[] light = gathers ? gathered(hit, part) : new float[9];
            for (int c = 0; c < 3; c++) {
                int channel = 3 * part + c;
                float value = factors.lit(c, gathers ? light[c] + sum(terms, part, DIFFUSE, c) : sum(terms, part, DIFFUSE, c),
                        sum(terms, part, SPECULAR, c), sum(terms, part, GRAZING, c));
                if (mirrorTracer == this) {
                    value += factors.mirrored(c, mirrored[channel]);
                    value += factors.refracted(c, refracted[channel]);
                }
                value += blurs ? factors.reflected(c, light[3 + c], light[6 + c]) : 0;
                color[channel] = value + factors.emitted(c, emitted(hit, part, c));
            }
        }
        if (mirrorTracer != this) {
            addEarlier(factors, mirrored, refracted, mirrorTracer.parts.weights(), color, earlier(0));
            addEarlier(factors, mirrored, refracted, mirrorTracer.parts.edgeWeights(), color, earlier(1));
        }
        return color;
    }

    private static void addEarlier(SurfaceFactors factors, float[] mirrored, float[] refracted, LightWeight[] weights, float[] to, int at) {
        float[] reflection = mix(mirrored, weights);
        float[] transmission = mix(refracted, weights);
        for (int c = 0; c < 3; c++) {
            to[at + c] = factors.mirrored(c, reflection[c]) + factors.refracted(c, transmission[c]);
        }
    }

    /** Returns one channel of the light that a surface emits in a film. */
    private float emitted(SurfacePoint hit, int part, int c) {
        int material = hit.material();
        FilmPart its = parts.get(part);
        float[] map =
                materials.texels(material).has(HitRows.ColumnGroup.GLOW_TEXEL) ? hit.maps().get(HitRows.ColumnGroup.GLOW_TEXEL) : null;
        float texel = map == null ? 1 : map[c];
        return switch (its.kind()) {
            case AMBIENCE -> materials.ambient(material, c);
            case REST -> materials.ownGlow(material, c) * texel;
            case LIGHT -> materials.material(material).bulb().light().equals(scene.lights().get(its.index()).name())
                    ? materials.bulbGlow(material, c) * texel : 0;
            case ENVIRONMENT_LIGHT, ENVIRONMENT_IMAGE -> 0;
        };
    }

    /** Returns the gathered light of a film: red, green, blue, and what blurred reflections show. */
    private float[] gathered(SurfacePoint hit, int part) {
        GatherSettings settings = GatherSettings.of(scene).get();
        if (settings.reflections()) {
            reflections = reflections == null
                    ? new ReferenceReflections(parts, geometry, settings, this::directLight, this::shownLight) : reflections;
            return reflections.at(hit, part);
        }
        indirect = indirect == null ? new ReferenceIndirect(parts, geometry, settings, this::directLight) : indirect;
        return Arrays.copyOfRange(indirect.at(hit), 3 * part, 3 * part + 3);
    }

    /** Returns the lights' diffuse sum at a surface outside pixels, by film: red, green, blue of each. */
    private float[] directLight(SurfacePoint hit) {
        float[][] terms = terms(hit, NO_PATTERN, false);
        float[] light = new float[3 * parts.count()];
        for (int channel = 0; channel < light.length; channel++) {
            light[channel] = sum(terms, channel / 3, DIFFUSE, channel % 3);
        }
        return light;
    }

    /** Returns the lights' diffuse and specular light that films show of a surface outside pixels: red, green, blue of each. */
    private float[] shownLight(SurfacePoint hit) {
        float[][] terms = terms(hit, NO_PATTERN, false);
        SurfaceFactors factors = new SurfaceFactors(hit, materials.material(hit.material()));
        float[] light = new float[3 * parts.count()];
        for (int channel = 0; channel < light.length; channel++) {
            int part = channel / 3;
            int c = channel % 3;
            light[channel] = factors.lit(c, sum(terms, part, DIFFUSE, c), sum(terms, part, SPECULAR, c), sum(terms, part, GRAZING, c));
        }
        return light;
    }

    /** Returns one channel of the sum of a term over the lights of a film. */
    private float sum(float[][] terms, int part, int term, int c) {
        int from = parts.get(part).from();
        float[] contributions = new float[parts.get(part).to() - from];
        for (int l = from; l < from + contributions.length; l++) {
            LightWeight weight = term == DIFFUSE ? lights[l].diffuse() : lights[l].specular();
            int factor = term == DIFFUSE ? DIFFUSE_FACTOR : SPECULAR_FACTOR;
            contributions[l - from] = LightingEquation.contribution(weight.channel(c), terms[l][term], terms[l][2], terms[l][factor + c]);
        }
        return LightingEquation.sum(contributions, 0, contributions.length);
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
            LightSource source = refines ? lights[l].source() : lights[l].source().forSurfels();
            terms[l] = source.isArea() ? meanTerms(source, hit, pattern, refines) : terms(source, hit, targets[l], HighlightFactor.NONE);
            if (!source.light().influence().gains().isNone()) {
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
        return names.reversed().stream().flatMap(name -> light.influence().gains().get(name).stream()).findFirst()
                .map(gain -> (float) light.limitedGain(gain)).orElse(1f);
    }

    /** Returns the terms of a point light. */
    private float[] terms(LightSource source, SurfacePoint hit, ShadowRayTarget target, HighlightFactor factor) {
        LightingEquation equation = equation(source, hit);
        float cosine = equation.cosine(hit.nx(), hit.ny(), hit.nz());
        if (state(source, hit, target, equation, cosine) != LightRows.LIT) {
            return new float[TERMS];
        }
        float[] tint = Transmittance.ofShadowRay(geometry, source, target, hit);
        Bsdf.Terms terms = Bsdf.of(materials.material(hit.material())).terms(equation, hit, cosine, factor);
        return new float[] {terms.diffuse(), terms.specular(), equation.falloff(), terms.grazing(), tint[0],
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
        return sample.type().hasPosition()
                ? sampleTargets.computeIfAbsent(sample.position(), at -> BruteForce.shadowRayTarget(geometry, at)) : null;
    }

    private static LightingEquation equation(LightSource source, SurfacePoint hit) {
        LightingEquation equation = new LightingEquation(source);
        equation.moveTo(hit.px(), hit.py(), hit.pz(), hit.nx(), hit.ny(), hit.nz());
        return equation;
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
                ? !BruteForce.isBlocked(casting, point, target)
                : !BruteForce.isBlocked(casting, new Ray(point, source.position()), Double.POSITIVE_INFINITY);
    }

    /** Returns the pixels that have several samples: {@code boolean[width * height]}, line by line. */
    private boolean[] finePixels() {
        PictureSettings picture = scene.picture();
        boolean[] fine = new boolean[picture.width() * picture.height()];
        switch (picture.sampling().antialias()) {
            case OFF -> Arrays.fill(fine, false);
            case EVERY -> Arrays.fill(fine, true);
            case EDGES -> {
                if (scene.camera().lens().isOpen()) {
                    Arrays.fill(fine, true);
                    return fine;
                }
                int[] colors = new int[fine.length];
                for (int i = 0; i < fine.length; i++) {
                    float[] color = edgePixel(i % picture.width(), i / picture.width());
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
