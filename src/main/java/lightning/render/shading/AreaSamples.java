package lightning.render.shading;

import java.util.stream.IntStream;
import java.util.stream.Stream;
import lightning.base.math.Transform;
import lightning.base.math.Vec3;
import lightning.render.trace.HitRows;
import lightning.render.trace.RowShadowRays;
import lightning.render.trace.SamplePattern;
import lightning.render.trace.primitive.TextureLookup;
import lightning.scene.SamplingSettings;
import lightning.scene.asset.SummedAreaTable;
import lightning.scene.asset.Texture;
import lightning.scene.light.AreaShape;
import lightning.scene.light.Light;
import lightning.scene.light.LightType;
import lightning.scene.light.ObjectSurface;
import lightning.scene.value.SceneLimits;
import org.jspecify.annotations.Nullable;

/**
 * Sample points of an area light in render space, or unit vectors towards a directional light. The light is the mean of its
 * samples.
 *
 * <p>Sample s of n is a point of the unit square: ((s + ½)/n + a, s·0.618… + b), both modulo 1, where 0.618… is the golden section.
 * Each row uses one of several pairs (a, b), its <em>rotation</em> (Cranley and Patterson 1976). Neighboring rows use different
 * samples, and the same image always uses the same ones. Rotation t is (t·0.754…, t·0.569…), the first two powers of the reciprocal
 * of the plastic number (Roberts 2018). The square maps to
 * <ul>
 * <li>a rectangle unchanged;
 * <li>a disc by (√u, 2πv) in polar coordinates;
 * <li>the sphere of a point or spot light by height 1 − 2u along y and longitude 2πv (Archimedes);
 * <li>the side of a tube by height along its axis and angle 2πv around it;
 * <li>the surface of an object by {@link ObjectSurface#point};
 * <li>a cap of directions by cosine 1 − u·(1 − cos spread) and longitude 2πv.
 * </ul>
 *
 * <p>If the light has an image, a sample has the mean color of a patch of it: the square of the unit square with area 1/n around the point of the
 * sample, n being the light's samples ({@link lightning.scene.light.AreaShape#samples}). On a disc, the patch is as large, in the square
 * around the disc that the image covers. Beyond the edges the image is mirrored. Seen from where the light shines, the image is upright.
 *
 * <p>Rows of pixel centers in a penumbra, from which some of the n samples are visible and others blocked, use up to {@value #REFINEMENT} times
 * as many: the first n, and the same ones moved by half the basis vectors of their lattice, (1/n, 0.618…) and (0, 1), and by both. All together are a
 * lattice of the same shape with half the spacing.
 *
 * <p>A row of a pixel center uses all n samples, in one of {@link #ROTATIONS} rotations, chosen by a hash of its point. A finer
 * sample of a pixel uses a part of the samples: every k-th of k·m, where k is the number of parts ({@link SamplePattern}) and m is
 * {@link SamplingSettings#lightSamples}. It uses no further ones in a penumbra: its few samples often are all visible, or all blocked, where
 * further ones would not be, so the mean over the pixel would be off to one side.
 */
public final class AreaSamples {
    /** Number of rotations of pixel centers. */
    public static final int ROTATIONS = 16;
    /** Largest ratio of the samples in a penumbra to those of other rows. */
    public static final int REFINEMENT = 4;

    /** Most samples of a surfel: light gathered or reflected from many of them is their mean. */
    private static final int SURFEL_SAMPLES = 4;

    private static final double GOLDEN = 0.6180339887498949;
    private static final double PLASTIC = 0.7548776662466927;
    private static final double PLASTIC_SQUARED = 0.5698402909980532;

    private final int count;
    private final int refinedCount;
    /** Number of patterns: rotations, for finer samples times parts. */
    public final int patterns;
    /** Coordinates of sample s in pattern t at {@code patterns·s + t}; must not be modified. */
    public final double[] x;
    public final double[] y;
    public final double[] z;
    /** Colors by the same index: red, green and blue; null if all are white. Must not be modified. */
    public final float @Nullable [][] color;
    private final @Nullable SampleNormals normals;
    private final double extent;
    private final Vec3 min;
    private final Vec3 max;

    private AreaSamples(Vec3 center, Vec3[] offsets, Vec3 @Nullable [] points, int count, int patterns, float @Nullable [][] colors,
            @Nullable SampleNormals normals) {
        this.normals = normals;
        this.patterns = patterns;
        this.count = count;
        refinedCount = offsets.length / patterns;
        x = new double[offsets.length];
        y = new double[offsets.length];
        z = new double[offsets.length];
        double farthest = 0;
        Vec3 minPoint = new Vec3(Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY);
        Vec3 maxPoint = minPoint.negated();
        for (int i = 0; i < offsets.length; i++) {
            Vec3 at = points == null ? center.plus(offsets[i]) : points[i];
            x[i] = at.x();
            y[i] = at.y();
            z[i] = at.z();
            farthest = Math.max(farthest, offsets[i].length());
            minPoint = new Vec3(Math.min(minPoint.x(), at.x()), Math.min(minPoint.y(), at.y()), Math.min(minPoint.z(), at.z()));
            maxPoint = new Vec3(Math.max(maxPoint.x(), at.x()), Math.max(maxPoint.y(), at.y()), Math.max(maxPoint.z(), at.z()));
        }
        color = colors;
        extent = farthest;
        min = minPoint;
        max = maxPoint;
    }

    /**
     * Creates the samples that rows of pixel centers use.
     *
     * @param light  a light for which {@link Light#isArea} holds
     * @param origin origin of render space in the scene
     * @param source the light's center, or the unit vector towards a directional light
     * @param axis   the unit direction in which the light shines
     */
    static AreaSamples ofCenters(Light light, Vec3 origin, Vec3 source, Vec3 axis) {
        return of(light, origin, source, axis, light.area().samples(), refined(light.area().samples()), 1, ROTATIONS);
    }

    /** Creates the samples that surfels use. */
    static AreaSamples ofSurfels(Light light, Vec3 origin, Vec3 source, Vec3 axis) {
        int n = Math.min(light.area().samples(), SURFEL_SAMPLES);
        return of(light, origin, source, axis, n, n, 1, ROTATIONS);
    }

    /** Creates the samples that rows of finer samples use. */
    static AreaSamples ofFineSamples(Light light, Vec3 origin, Vec3 source, Vec3 axis, SamplingSettings sampling) {
        int n = sampling.lightSamples(light.area().samples());
        return of(light, origin, source, axis, n, n, SamplePattern.parts(sampling.grid()), SamplePattern.rotations(sampling.grid()));
    }

    /**
     * @param n       samples of a row
     * @param refined samples of a row in a penumbra
     * @param parts   number of parts of the whole sample pattern
     */
    private static AreaSamples of(Light light, Vec3 origin, Vec3 source, Vec3 axis, int n, int refined, int parts, int rotations) {
        AreaShape area = light.area();
        int patterns = parts * rotations;
        // A ball and a cone of directions look the same for every up vector.
        Vec3 right = (light.type().isSurface() ? area : AreaShape.DEFAULT).right(axis);
        Vec3 top = right.cross(axis);
        Vec3[] offsets = new Vec3[refined * patterns];
        SummedAreaTable image = light.faceImage().map(Texture::areas).orElse(null);
        ObjectSurface surface = light.type() == LightType.OBJECT ? area.surface().orElseThrow() : null;
        var images = new TextureLookup();
        float[] rgb = new float[3];
        SampleNormals normals = surface == null ? null : new SampleNormals(offsets.length);
        Vec3[] points = new Vec3[offsets.length];
        float[][] colors = image == null && (surface == null || surface.glowMap().isEmpty()) ? null : new float[3][offsets.length];
        for (int pattern = 0; pattern < patterns; pattern++) {
            int t = pattern / parts;
            for (int i = 0; i < refined; i++) {
                double s = parts * (i % n) + pattern % parts + 0.5 * (i / n % 2);
                double u = fraction((s + 0.5) / (n * parts) + t * PLASTIC);
                double v = fraction(s * GOLDEN + t * PLASTIC_SQUARED + 0.5 * (i / n / 2));
                if (surface != null && normals != null) {
                    ObjectSurface.Point point = surface.point(u, v, origin);
                    points[patterns * i + pattern] = point.position();
                    offsets[patterns * i + pattern] = point.position().minus(source);
                    normals.set(patterns * i + pattern, point.normal(), point.bothSides());
                    if (colors != null) {
                        images.lookUpAt(surface.glowMap().orElseThrow(), point.u(), point.v(), rgb);
                        for (int c = 0; c < 3; c++) {
                            colors[c][patterns * i + pattern] = rgb[c];
                        }
                    }
                    continue;
                }
                offsets[patterns * i + pattern] = switch (light.type()) {
                    case RECT -> right.times((u - 0.5) * area.width()).plus(top.times((v - 0.5) * area.height()));
                    case DISC -> onCircle(right, top, area.radius() * Math.sqrt(u), v);
                    case POINT, SPOT -> onCircle(new Vec3(1, 0, 0), new Vec3(0, 0, 1), area.radius() * 2 * Math.sqrt(u * (1 - u)), v)
                            .plus(new Vec3(0, area.radius() * (1 - 2 * u), 0));
                    case TUBE -> onCircle(right, top, area.radius(), v).plus(axis.times((u - 0.5) * area.height()));
                    case OBJECT -> throw new IllegalArgumentException("an object has samples on its surface only");
                    case DIRECTIONAL -> {
                        double cos = 1 - u * (1 - Transform.cosDegrees(area.spread()));
                        Vec3 toward = source.times(cos).plus(onCircle(right, top, Math.sqrt(Math.max(0, 1 - cos * cos)), v));
                        yield toward.normalized().minus(source);
                    }
                };
                if (image != null && colors != null) {
                    boolean disc = light.type() == LightType.DISC;
                    double across = disc ? 0.5 + 0.5 * Math.sqrt(u) * Transform.cosDegrees(360 * v) : u;
                    double up = disc ? 0.5 + 0.5 * Math.sqrt(u) * Transform.sinDegrees(360 * v) : v;
                    double half = 0.5 * Math.sqrt((disc ? Math.PI / 4 : 1) / area.samples());
                    for (int c = 0; c < 3; c++) {
                        // A viewer of the face looks against the light's direction, so that left and right are swapped.
                        colors[c][patterns * i + pattern] = image.mean(1 - across - half, 1 - up - half, 1 - across + half,
                                1 - up + half, c);
                    }
                }
            }
        }
        return new AreaSamples(source, offsets, surface == null ? null : points, n, patterns, colors, normals);
    }

    private static Vec3 onCircle(Vec3 right, Vec3 top, double radius, double rotation) {
        return right.times(radius * Transform.cosDegrees(360 * rotation)).plus(top.times(radius * Transform.sinDegrees(360 * rotation)));
    }

    private static double fraction(double v) {
        return v - Math.floor(v);
    }

    /** Returns the rotation of a row: the upper bits of a hash of its point, in which 0 and −0 are equal. */
    public static int rotation(float px, float py, float pz) {
        int h = Float.floatToRawIntBits(px + 0f) * 0x9E3779B1 + Float.floatToRawIntBits(py + 0f) * 0x85EBCA77
                + Float.floatToRawIntBits(pz + 0f) * 0xC2B2AE3D;
        h = (h ^ h >>> 15) * 0x2C1B3C6D;
        return (h ^ h >>> 12) * 0x297A2D39 >>> 28;
    }

    /** Writes the pattern of each row, and 0 for lanes beyond the last row. */
    public static void writePatterns(HitRows rows, RowShadowRays rays) {
        for (int i = 0; i < HitRows.paddedLength(rows.count); i++) {
            rays.pattern[i] = i >= rows.count ? 0
                    : rows.pattern == null ? rotation(rows.px[i], rows.py[i], rows.pz[i]) : rows.pattern[i] & 0xFF;
            rays.patternLanes[i] = rays.pattern[i];
        }
    }

    /** Returns the directions to which the samples of an object shine; null for other lights. */
    public @Nullable SampleNormals normals() {
        return normals;
    }

    /** Returns the index of sample {@code s} in a pattern. */
    public int index(int s, int pattern) {
        return patterns * s + pattern;
    }

    /** Returns the number of samples of a row. */
    public int samples() {
        return count;
    }

    /** Returns the number of samples of a row in a penumbra; the first ones are those of other rows. */
    public int refinedSamples() {
        return refinedCount;
    }

    /** Returns the samples of a pixel center in a penumbra of a light with n samples elsewhere. */
    public static int refined(int n) {
        return n * Math.min(REFINEMENT, SceneLimits.MAX_LIGHT_SAMPLES / n);
    }

    /** Returns the position of sample {@code s} in a pattern. */
    public Vec3 position(int pattern, int s) {
        int i = index(s, pattern);
        return new Vec3(x[i], y[i], z[i]);
    }

    /** Returns the positions of all samples in all patterns, by {@link #index}. */
    public Stream<Vec3> positions() {
        return IntStream.range(0, x.length).mapToObj(i -> new Vec3(x[i], y[i], z[i]));
    }

    /** Returns the largest distance of a sample from the center. */
    public double extent() {
        return extent;
    }

    /** Returns the smallest coordinates of all samples. */
    public Vec3 low() {
        return min;
    }

    /** Returns the largest coordinates of all samples. */
    public Vec3 high() {
        return max;
    }
}
