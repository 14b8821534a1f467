package lightning.render.shading;

import java.util.Arrays;
import java.util.HashMap;
import java.util.Map;
import lightning.base.math.Ray;
import lightning.base.math.Vec3;
import lightning.render.image.Film;
import lightning.render.trace.Bounce;
import lightning.render.trace.Eye;
import lightning.render.trace.Geometry;
import lightning.render.trace.HitCode;
import lightning.render.trace.MaterialTable;
import lightning.render.trace.SurfacePoint;
import lightning.render.trace.tree.WayEnd;
import lightning.scene.Picture;
import lightning.scene.Scene;

/**
 * The oracle: traces every pixel from the scene alone, ray by ray, as §2.1 of the paper tells it.
 *
 * <p>It tests each ray against every shape, keeps nothing, and is slow. Every other way to the
 * picture must agree with it in every bit.
 */
public final class ReferenceTracer {
    private final Scene scene;
    private final Geometry geometry;
    private final MaterialTable materials;
    private final Luminaire[] lights;
    private final WayEnd[] ends;
    /** Where ways to the samples of larger lights end. */
    private final Map<Vec3, WayEnd> sampleEnds = new HashMap<>();
    private final ReferenceTracer mirrors;

    public ReferenceTracer(Scene scene) {
        this(scene, scene);
    }

    /**
     * A trace of {@code scene} whose mirrors show {@code mirrored}: what a picture with stale reflections
     * must be (paper §4.8). The two may differ in lights, world and materials.
     */
    public ReferenceTracer(Scene scene, Scene mirrored) {
        this.scene = scene;
        mirrors = scene == mirrored ? this : new ReferenceTracer(mirrored);
        geometry = new Geometry(scene);
        materials = geometry.materials();
        lights = Luminaire.all(scene);
        ends = Arrays.stream(lights).map(Luminaire::lamp).map(lamp -> lamp.type().hasPosition() ? geometry.endOfAll(lamp.source()) : null)
                .toArray(WayEnd[]::new);
    }

    /** The whole picture. */
    public Film trace() {
        return trace(this);
    }

    /** The whole picture over the samples that another picture of the same size has. */
    public Film trace(ReferenceTracer sampled) {
        boolean[] fine = sampled.finePixels();
        int width = scene.picture().width();
        int height = scene.picture().height();
        float[] rgb = new float[3 * width * height];
        for (int y = 0; y < height; y++) {
            for (int x = 0; x < width; x++) {
                float[] color = fine[y * width + x] ? mean(x, y, sampled.scene.picture().sampling().grid()) : pixel(x, y);
                System.arraycopy(color, 0, rgb, 3 * (y * width + x), 3);
            }
        }
        return Film.ofScanlines(width, height, rgb);
    }

    /** The linear colour at the centre of one pixel, {@code float[3]}. */
    public float[] pixel(int x, int y) {
        return color(new Eye(scene).through(x, y), scene.picture().depth());
    }

    /** The mean of a pixel's samples. */
    private float[] mean(int x, int y, int grid) {
        float[][] samples = new float[3][grid * grid];
        for (int s = 0; s < grid * grid; s++) {
            float[] color = color(new Eye(scene).through(x, y, s, grid), scene.picture().depth());
            for (int c = 0; c < 3; c++) {
                samples[c][s] = color[c];
            }
        }
        return new float[] {mean(samples[0]), mean(samples[1]), mean(samples[2])};
    }

    private static float mean(float[] samples) {
        float sum = LightingEquation.sum(samples, 0, samples.length);
        return Float.isFinite(sum) ? sum / samples.length : SampleMean.ofBright(samples, 0, samples.length);
    }

    /** The colour that a ray brings; {@code depth} more mirrors may be followed. */
    private float[] color(Ray ray, int depth) {
        int primitive = geometry.nearestOfAll(ray);
        if (primitive < 0) {
            return Backdrop.color(scene.world(), ray.direction());
        }
        SurfacePoint at = geometry.surfaceOfAll(primitive, ray);
        int material = at.material();
        float[] mirrored = {0, 0, 0};
        if (materials.isReflective(material) && depth > 0) {
            mirrored = mirrors.color(at.mirrored(), depth - 1);
        }
        Ray through = materials.isClear(material) && depth > 0 ? at.refracted() : null;
        float[] refracted = through == null ? new float[3] : mirrors.color(through, depth - 1);
        float[] color = new float[3];
        float[] diffuse = new float[lights.length];
        float[] specular = new float[lights.length];
        float[] grazing = new float[lights.length];
        float[][] terms = terms(at);
        for (int c = 0; c < 3; c++) {
            for (int l = 0; l < lights.length; l++) {
                float weight = weight(lights[l], c);
                diffuse[l] = LightingEquation.contribution(weight, terms[l][0], terms[l][2], terms[l][4 + c]);
                specular[l] = LightingEquation.contribution(weight, terms[l][1], terms[l][2], terms[l][4 + c]);
                grazing[l] = LightingEquation.contribution(weight, terms[l][3], terms[l][2], terms[l][4 + c]);
            }
            color[c] = materials.isClear(material) ? clear(at, c, diffuse, specular, grazing, mirrored, refracted) : LightingEquation.color(
                    materials.ambient(material, c), (float) scene.world().ambience(),
                    at.diffuse()[c], LightingEquation.sum(diffuse, 0, lights.length),
                    at.specular()[c], LightingEquation.sum(specular, 0, lights.length), LightingEquation.sum(grazing, 0, lights.length),
                    materials.reflective(material, c), mirrored[c]);
        }
        return color;
    }

    /** One channel of the colour of a clear surface. */
    private float clear(SurfacePoint at, int c, float[] diffuse, float[] specular, float[] grazing, float[] mirrored, float[] refracted) {
        return new SurfaceShare(at).color(c, materials.ambient(at.material(), c), (float) scene.world().ambience(),
                at.diffuse()[c], LightingEquation.sum(diffuse, 0, lights.length),
                at.specular()[c], LightingEquation.sum(specular, 0, lights.length), LightingEquation.sum(grazing, 0, lights.length),
                materials.reflective(at.material(), c), mirrored[c], refracted[c]);
    }

    /**
     * For each light its diffuse and specular term, falloff and grazing term at a point, and red, green and blue of what passes; all 0 where
     * it does not reach.
     */
    private float[][] terms(SurfacePoint at) {
        float[][] terms = new float[lights.length][7];
        for (int l = 0; l < lights.length; l++) {
            Lamp lamp = lights[l].lamp();
            terms[l] = lamp.isArea() ? mean(lamp, at) : terms(lamp, at, ends[l]);
        }
        return terms;
    }

    /** The terms of a light that is a point. */
    private float[] terms(Lamp lamp, SurfacePoint at, WayEnd end) {
        LightingEquation equation = equation(lamp, at);
        float cosine = equation.cosine(at.nx(), at.ny(), at.nz());
        if (state(lamp, at, end, equation, cosine) != LightRows.LIT) {
            return new float[7];
        }
        float[] tint = Transmittance.onWay(geometry, lamp, end, at);
        return new float[] {diffuse(equation, at, cosine), specular(equation, at), equation.falloff(), grazing(equation, at), tint[0],
            tint[1],
            tint[2]};
    }

    /** The means over the samples of a larger light, falloff and all. */
    private float[] mean(Lamp lamp, SurfacePoint at) {
        int samples = lamp.area().samples();
        double diffuse = 0;
        double specular = 0;
        double grazing = 0;
        double[] tint = new double[3];
        int free = 0;
        for (int s = 0; s < samples; s++) {
            Lamp sample = lamp.sample(LampArea.turn(at.px(), at.py(), at.pz()), s);
            // Wherever its cone ends, a way that is free counts.
            if (equation(sample, at).cosine(at.nx(), at.ny(), at.nz()) > 0 && isVisible(sample, end(sample), at)) {
                float[] one = Transmittance.onWay(geometry, sample, end(sample), at);
                tint[0] += one[0];
                tint[1] += one[1];
                tint[2] += one[2];
                free++;
            }
            float[] terms = terms(sample, at, end(sample));
            diffuse += (double) terms[0] * terms[2];
            specular += (double) terms[1] * terms[2];
            grazing += (double) terms[3] * terms[2];
        }
        return new float[] {LightingEquation.mean(diffuse, samples), LightingEquation.mean(specular, samples), 1,
            LightingEquation.mean(grazing, samples), LightingEquation.mean(tint[0], free == 0 ? 1 : free),
            LightingEquation.mean(tint[1], free == 0 ? 1 : free), LightingEquation.mean(tint[2], free == 0 ? 1 : free)};
    }

    private WayEnd end(Lamp sample) {
        return sample.type().hasPosition() ? sampleEnds.computeIfAbsent(sample.source(), geometry::endOfAll) : null;
    }

    private static LightingEquation equation(Lamp lamp, SurfacePoint at) {
        LightingEquation equation = new LightingEquation(lamp);
        equation.at(at.px(), at.py(), at.pz(), at.nx(), at.ny(), at.nz());
        return equation;
    }

    private float diffuse(LightingEquation equation, SurfacePoint at, float cosine) {
        return materials.isMetallic(at.material()) ? equation.matte(at.nx(), at.ny(), at.nz(), at.vx(), at.vy(), at.vz()) : cosine;
    }

    private float grazing(LightingEquation equation, SurfacePoint at) {
        return materials.isMetallic(at.material())
                ? equation.grazing(at.nx(), at.ny(), at.nz(), at.vx(), at.vy(), at.vz(), materials.alpha(at.material())) : 0;
    }

    private float specular(LightingEquation equation, SurfacePoint at) {
        if (materials.isMetallic(at.material())) {
            return equation.gloss(at.nx(), at.ny(), at.nz(), at.vx(), at.vy(), at.vz(), materials.alpha(at.material()));
        }
        return equation.specular(at.nx(), at.ny(), at.nz(), at.vx(), at.vy(), at.vz(), materials.shininess(at.material()));
    }

    private int state(Lamp lamp, SurfacePoint at, WayEnd end, LightingEquation equation, float cosine) {
        return !(cosine > 0) ? LightRows.AWAY
                : !equation.insideCone() || !isLinked(lamp, at) ? LightRows.OUTSIDE
                : isVisible(lamp, end, at) ? LightRows.LIT : LightRows.SHADOWED;
    }

    /** Whether a light shines on the shape of a point. */
    private boolean isLinked(Lamp lamp, SurfacePoint at) {
        return geometry.linked(lamp.light().illuminates())[at.primitive()];
    }

    /** Whether none of the shapes that throw shadows in its light stands between a point and a light. */
    private boolean isVisible(Lamp lamp, WayEnd end, SurfacePoint at) {
        Vec3 point = new Vec3(at.px(), at.py(), at.pz());
        Geometry casting = geometry.casting(lamp.light().shadowedBy());
        return lamp.type().hasPosition()
                ? !casting.blockedByAny(point, end)
                : !casting.blockedByAny(new Ray(point, lamp.source()), Double.POSITIVE_INFINITY);
    }

    /**
     * Adds what anti-aliasing sees along a ray ({@link EdgeCodes}).
     *
     * @param place where it is seen ({@link EdgeCoder#place})
     * @param sums  the code of shapes and that of lights, {@code int[2]}
     */
    private void look(Ray ray, int depth, int place, int[] sums) {
        int primitive = geometry.nearestOfAll(ray);
        if (primitive < 0) {
            return;
        }
        SurfacePoint at = geometry.surfaceOfAll(primitive, ray);
        int hit = HitCode.of(geometry.number(primitive), at.nx(), at.ny(), at.nz());
        sums[0] += HitCode.seen(materials.isTextured(at.material())
                ? HitCode.textured(hit, at.texel()[0], at.texel()[1], at.texel()[2]) : hit, place);
        for (int l = 0; l < lights.length; l++) {
            if (!lights[l].isDark()) {
                int code = look(l, at);
                sums[1] += place == 0 ? code : HitCode.seen(code, place);
            }
        }
        if (materials.isReflective(at.material()) && depth > 0) {
            mirrors.look(at.mirrored(), depth - 1, EdgeCoder.place(place, Bounce.MIRRORED), sums);
        }
        Ray through = materials.isClear(at.material()) && depth > 0 ? at.refracted() : null;
        if (through != null) {
            mirrors.look(through, depth - 1, EdgeCoder.place(place, Bounce.REFRACTED), sums);
        }
    }

    private int look(int light, SurfacePoint at) {
        Lamp lamp = lights[light].lamp();
        if (lamp.isArea()) {
            return EdgeCoder.code(light, farthest(lamp, at), false, false, 0);
        }
        LightingEquation equation = equation(lamp, at);
        int state = state(lamp, at, ends[light], equation, equation.cosine(at.nx(), at.ny(), at.nz()));
        return EdgeCoder.code(light, state, state == LightRows.LIT && isTinted(Transmittance.onWay(geometry, lamp, ends[light], at)),
                materials.isSpecular(at.material()), specular(equation, at));
    }

    private static boolean isTinted(float[] tint) {
        return tint[0] != 1 || tint[1] != 1 || tint[2] != 1;
    }

    /** The state of the sample that comes farthest: lit where any is, else shadowed where any shines here. */
    private int farthest(Lamp lamp, SurfacePoint at) {
        int farthest = LightRows.AWAY;
        for (int s = 0; s < lamp.area().samples(); s++) {
            Lamp sample = lamp.sample(LampArea.turn(at.px(), at.py(), at.pz()), s);
            LightingEquation equation = equation(sample, at);
            farthest = Math.max(farthest, state(sample, at, end(sample), equation, equation.cosine(at.nx(), at.ny(), at.nz())));
        }
        return farthest;
    }

    /** The pixels that have several samples: {@code boolean[width * height]}, line by line. */
    private boolean[] finePixels() {
        Picture picture = scene.picture();
        boolean[] fine = new boolean[picture.width() * picture.height()];
        switch (picture.sampling().antialias()) {
            case OFF -> Arrays.fill(fine, false);
            case EVERY -> Arrays.fill(fine, true);
            case EDGES -> {
                Eye eye = new Eye(scene);
                int[][] codes = new int[fine.length][2];
                for (int i = 0; i < fine.length; i++) {
                    look(eye.through(i % picture.width(), i / picture.width()), picture.depth(), 0, codes[i]);
                }
                for (int i = 0; i < fine.length; i++) {
                    int x = i % picture.width();
                    fine[i] = x > 0 && !Arrays.equals(codes[i], codes[i - 1])
                            || x + 1 < picture.width() && !Arrays.equals(codes[i], codes[i + 1])
                            || i >= picture.width() && !Arrays.equals(codes[i], codes[i - picture.width()])
                            || i + picture.width() < fine.length && !Arrays.equals(codes[i], codes[i + picture.width()]);
                }
            }
        }
        return fine;
    }

    private static float weight(Luminaire light, int channel) {
        return switch (channel) {
            case 0 -> light.red();
            case 1 -> light.green();
            default -> light.blue();
        };
    }
}
