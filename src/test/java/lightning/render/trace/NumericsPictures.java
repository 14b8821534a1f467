package lightning.render.trace;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.function.ToDoubleFunction;
import lightning.base.math.Ray;
import lightning.base.math.Rgb;
import lightning.base.math.Vec3;
import lightning.format.image.ImageFile;
import lightning.render.image.Film;
import lightning.render.image.ViewTransform;
import lightning.render.trace.primitive.SurfaceHit;
import lightning.render.trace.solid.SolidGeometry;
import lightning.scene.Camera;
import lightning.scene.PictureSettings;
import lightning.scene.Scene;
import lightning.scene.World;
import lightning.scene.asset.Texture;
import lightning.scene.asset.TextureMap;
import lightning.scene.material.AlphaCutout;
import lightning.scene.material.BumpMapping;
import lightning.scene.material.Material;
import lightning.scene.material.Transmission;
import lightning.scene.node.Shape;
import lightning.scene.node.Solid;
import lightning.scene.value.Placement;

/** Program that renders the images of docs/numerics.md, the textbook's formula on the left and Lightning's on the right. */
final class NumericsPictures {
    private static final int SIZE = 160;
    private static final Vec3 TO_LIGHT = new Vec3(-0.5, 0.7, 0.6).normalized();
    private static final Path FOLDER = Path.of("docs", "pictures");

    private NumericsPictures() {}

    /** Run by {@code mvn -q test-compile exec:exec@test-main -Dlightning.main=lightning.render.trace.NumericsPictures}. */
    public static void main(String[] args) throws IOException {
        Files.createDirectories(FOLDER);
        write("far-sphere", panel(x -> farView(Solid.SPHERE, x, 3e7, new Vec3(0, 0, -1), true)),
                panel(x -> farView(Solid.SPHERE, x, 3e7, new Vec3(0, 0, -1), false)));
        Vec3 generator = new Vec3(0, -1, -1).normalized();
        write("far-cone", panel(x -> farView(Solid.CONE, x, 3e6, generator, true)),
                panel(x -> farView(Solid.CONE, x, 3e6, generator, false)));
        Vec3 at = new Vec3(148376, 1234, -223423);
        write("acne", panel(x -> shadowValue(x, at, 2, RayOffset.FROM_THE_HIT)), panel(x -> shadowValue(x, at, 2, RayOffset.LIGHTNING)));
        write("epsilon", panel(x -> shadowValue(x, new Vec3(0, 0, -4e-4), 1e-4, RayOffset.BY_EPSILON)),
                panel(x -> shadowValue(x, new Vec3(0, 0, -4e-4), 1e-4, RayOffset.LIGHTNING)));
        Vec3 small = new Vec3(0, 0, -4e-4);
        write("penumbra", panel(x -> softShadow(x, small, 1e-4, RayOffset.BY_EPSILON)),
                panel(x -> softShadow(x, small, 1e-4, RayOffset.LIGHTNING)));
        write("lamp", panel(x -> lightOnSurface(x, false)), panel(x -> lightOnSurface(x, true)));
        write("relief", panel(x -> bumpy(x, false)), panel(x -> bumpy(x, true)));
        write("hole", panel(x -> fenceValue(x, true)), panel(x -> fenceValue(x, false)));
        write("glass-shadow", panel(x -> glassShadow(x, true)), panel(x -> glassShadow(x, false)));
        write("far-scene", panel(x -> normalFromFloats(x, new Vec3(4e6, 2e6, -3e6))), panel(x -> normalFromFloats(x, Vec3.ZERO)));
    }

    private static float[] panel(ToDoubleFunction<double[]> shade) {
        float[] values = new float[SIZE * SIZE];
        for (int i = 0; i < values.length; i++) {
            values[i] =
                    (float) shade.applyAsDouble(new double[] {(i % SIZE + 0.5) / SIZE * 2.4 - 1.2, 1.2 - (i / SIZE + 0.5) / SIZE * 2.4});
        }
        return values;
    }

    private static void write(String name, float[] left, float[] right) throws IOException {
        int width = 2 * SIZE + 4;
        float[] rgb = new float[3 * width * SIZE];
        for (int y = 0; y < SIZE; y++) {
            for (int x = 0; x < width; x++) {
                float value = x < SIZE ? left[y * SIZE + x] : x < SIZE + 4 ? 1 : right[y * SIZE + x - SIZE - 4];
                java.util.Arrays.fill(rgb, 3 * (y * width + x), 3 * (y * width + x) + 3, value);
            }
        }
        ImageFile.write(FOLDER.resolve("numerics-" + name + ".png"), Film.ofScanlines(width, SIZE, rgb), ViewTransform.DEFAULT);
    }

    /** Renders one canonical solid with parallel rays, shaded by its normal. */
    private static double farView(Solid.Canonical solid, double[] x, double distance, Vec3 d, boolean naive) {
        Vec3 right = new Vec3(1, 0, 0);
        Vec3 up = right.cross(d);
        Vec3 middle = solid.equals(Solid.SPHERE) ? Vec3.ZERO : new Vec3(0, 0.4, 0);
        Vec3 o = middle.plus(right.times(x[0])).plus(up.times(x[1])).minus(d.times(distance));
        Geometry geometry = Geometry.of(TraceScenes.singleShape(solid, Placement.IDENTITY, Vec3.ZERO, new Vec3(0, 0, -1)));
        double t = naive ? NaiveSolids.distance(solid, o.x(), o.y(), o.z(), d.x(), d.y(), d.z()) : geometry.distance(0, new Ray(o, d));
        if (t == SolidGeometry.MISS) {
            return 0.02;
        }
        SurfaceHit surface = new SurfaceHit();
        surface.compute(geometry.primitives(), 0, 0, o.x(), o.y(), o.z(), d.x(), d.y(), d.z(), t);
        return 0.1 + Math.max(0, TO_LIGHT.dot(new Vec3(surface.nx, surface.ny, surface.nz)));
    }

    private enum RayOffset { FROM_THE_HIT, BY_EPSILON, LIGHTNING }

    /** Renders a ball's shadow by a light 40 degrees wide, as the mean of 256 directions. */
    private static double softShadow(double[] x, Vec3 at, double scale, RayOffset leaving) {
        int samples = 256;
        Vec3 right = TO_LIGHT.cross(Vec3.Y).normalized();
        Vec3 up = right.cross(TO_LIGHT);
        double sum = 0;
        for (int s = 0; s < samples; s++) {
            double radius = Math.tan(Math.toRadians(20)) * Math.sqrt((s + 0.5) / samples);
            double rotation = 2 * Math.PI * 0.6180339887498949 * s;
            sum += shadowValue(x, at, scale, leaving,
                    TO_LIGHT.plus(right.times(radius * Math.cos(rotation))).plus(up.times(radius * Math.sin(rotation))).normalized());
        }
        return sum / samples;
    }

    private static double shadowValue(double[] x, Vec3 at, double scale, RayOffset leaving) {
        return shadowValue(x, at, scale, leaving, TO_LIGHT);
    }

    /** Renders a ball over a floor, seen from the origin, with its shadow. */
    private static double shadowValue(double[] x, Vec3 at, double scale, RayOffset leaving, Vec3 toLight) {
        Geometry geometry = Geometry.of(TraceScenes.ballOnFloor(at, scale));
        Vec3 forward = at.normalized();
        Vec3 right = forward.cross(Vec3.Y).normalized();
        Vec3 up = right.cross(forward);
        Vec3 target = at.plus(right.times(1.6 * scale * x[0])).plus(up.times(1.6 * scale * x[1]));
        Ray ray = new Ray(Vec3.ZERO, target.normalized());
        int shape = BruteForce.nearest(geometry, ray);
        if (shape < 0) {
            return 0.02;
        }
        SurfacePoint p = geometry.surface(shape, ray);
        Vec3 normal = new Vec3(p.nx(), p.ny(), p.nz());
        Vec3 hit = ray.direction().times(geometry.distance(shape, ray));
        Vec3 from = leaving == RayOffset.LIGHTNING ? new Vec3(p.px(), p.py(), p.pz())
                : new Vec3((float) hit.x(), (float) hit.y(), (float) hit.z());
        double minDistance = leaving == RayOffset.BY_EPSILON ? 1e-4 : 0;
        boolean dark = false;
        for (int s = 0; s < geometry.primitiveCount(); s++) {
            double t = geometry.distance(s, new Ray(from, toLight));
            dark |= t > minDistance && t < SolidGeometry.MISS;
        }
        return 0.1 + (dark ? 0 : Math.max(0, toLight.dot(normal)));
    }

    /** Renders a bumpy ball lit from its left; {@code usesLift} selects whether shadow rays test the ball itself. */
    private static double bumpy(double[] x, boolean usesLift) {
        Geometry geometry = Geometry.of(bumpyBall());
        Ray ray = new Ray(Vec3.ZERO, new Vec3(x[0], x[1], -9).normalized());
        if (BruteForce.nearest(geometry, ray) < 0) {
            return 0.02;
        }
        SurfacePoint p = geometry.surface(0, ray);
        Vec3 toLight = new Vec3(-0.95, 0.3, 0.1).normalized();
        boolean dark = usesLift && BruteForce.isBlocked(geometry, new Ray(new Vec3(p.px(), p.py(), p.pz()), toLight), SolidGeometry.MISS);
        return 0.05 + (dark ? 0 : Math.max(0, toLight.dot(new Vec3(p.nx(), p.ny(), p.nz()))));
    }

    private static Scene bumpyBall() {
        int side = 64;
        float[] heights = new float[3 * side * side];
        for (int i = 0; i < heights.length; i++) {
            heights[i] =
                    (float) (0.5 + 0.5 * Math.sin(2 * Math.PI * (i / 3 % side) / side) * Math.sin(2 * Math.PI * (i / 3 / side) / side));
        }
        BumpMapping relief =
                BumpMapping.NONE.withBump(Optional.of(new TextureMap("bumps.png", 12, 6, new Texture(side, side, heights))))
                        .withHeight(0.08);
        return new Scene(PictureSettings.DEFAULT, new Camera(Vec3.ZERO, new Vec3(0, 0, -1), Vec3.Y, 40), World.DEFAULT,
                List.of(Material.of("bumps").withBumpMapping(relief)),
                List.of(new Shape(Solid.SPHERE, "ball", "bumps", new Placement(new Vec3(0, 0, -9), Vec3.ZERO, Vec3.ONE))), List.of());
    }

    /** Renders a fence 5·10⁻⁵ in front of a wall; {@code restarts} selects whether a ray restarts 10⁻⁴ behind a hole. */
    private static double fenceValue(double[] x, boolean restarts) {
        int side = 16;
        float[] there = new float[3 * side * side];
        for (int i = 0; i < there.length; i++) {
            there[i] = i / 3 % side < 5 || i / 3 / side < 5 ? 1 : 0;
        }
        var laths = new TextureMap("fence.png", 5, 5, new Texture(side, side, there));
        Vec3 upright = new Vec3(90, 0, 0);
        Vec3 size = new Vec3(2, 1, 2);
        Scene scene = new Scene(PictureSettings.DEFAULT, new Camera(Vec3.ZERO, new Vec3(0, 0, -1), Vec3.Y, 40), World.DEFAULT,
                List.of(Material.of("cut").withCutout(AlphaCutout.NONE.withMap(Optional.of(laths)))),
                List.of(new Shape(Solid.PLANE, "fence", "cut", new Placement(new Vec3(0, 0, -4), upright, size)),
                        new Shape(Solid.PLANE, "wall", "default", new Placement(new Vec3(0, 0, -4 - 5e-5), upright, size))),
                List.of());
        Geometry geometry = Geometry.of(scene);
        Geometry whole = Geometry.of(scene.withMaterials(List.of(Material.of("cut"))));
        Ray ray = new Ray(Vec3.ZERO, new Vec3(x[0], x[1], -4).normalized());
        int hit = BruteForce.nearest(geometry, ray);
        if (restarts && BruteForce.nearest(whole, ray) == 0 && hit != 0) {
            Vec3 behind = ray.direction().times(whole.distance(0, ray) + 1e-4);
            hit = BruteForce.nearest(whole, new Ray(behind, ray.direction()));
        }
        return hit == 0 ? 0.8 : hit == 1 ? 0.25 : 0.02;
    }

    /** Renders a floor under a glass ball and a sun; {@code inside} selects the angle inside for the fraction that leaves. */
    private static double glassShadow(double[] x, boolean inside) {
        Transmission glass = Transmission.NONE.withColor(Rgb.WHITE).withIor(1.5);
        double out = Math.sqrt(x[0] * x[0] + x[1] * x[1]);
        if (out >= 1) {
            return 0.8;
        }
        float sine = (float) out;
        float cosine = (float) Math.sqrt(1 - out * out);
        float enters = Refraction.fresnelReflectance(glass, false, 0, cosine, sine, 0, -1, 0);
        float leaves = Refraction.fresnelReflectance(glass, inside, 0, cosine, sine, 0, -1, 0);
        return 0.8 * (1 - enters) * (1 - leaves);
    }

    /**
     * Renders a light on a tilted square above a floor, seen from above; {@code liesOnSurface} selects the test for lights on
     * the square.
     */
    private static double lightOnSurface(double[] x, boolean liesOnSurface) {
        Placement square = new Placement(new Vec3(0, 2, -0.5), new Vec3(37, 20, 10), new Vec3(1.5, 1, 1.5));
        Vec3 eye = new Vec3(0, 7, 5);
        Geometry geometry = Geometry.of(TraceScenes.shapeOverFloor(Solid.PLANE, square, eye));
        Vec3 light = geometry.toRenderSpace(square.transform().transformPoint(new Vec3(0.1, 0, 0.2)));
        Ray ray = new Ray(Vec3.ZERO, new Vec3(3 * x[0], 0.5 + 2.5 * x[1], -2 * x[1]).minus(eye).normalized());
        int shape = BruteForce.nearest(geometry, ray);
        if (shape < 0) {
            return 0.02;
        }
        SurfacePoint p = geometry.surface(shape, ray);
        Vec3 from = new Vec3(p.px(), p.py(), p.pz());
        Vec3 to = light.minus(from);
        boolean dark = liesOnSurface ? BruteForce.isBlocked(geometry, from, geometry.shadowRayTarget(light))
                : BruteForce.isBlocked(geometry, new Ray(from, to), 1);
        return 0.1 + (dark ? 0 : Math.max(0, to.normalized().dot(new Vec3(p.nx(), p.ny(), p.nz()))));
    }

    /** Computes the normal for a light next to the row, with positions as floats from a distant origin or from the eye. */
    private static double normalFromFloats(double[] x, Vec3 eye) {
        double y = x[1];
        double z = -3;
        Vec3 p = new Vec3((float) (eye.x() + x[0]), (float) (eye.y() + y), (float) (eye.z() + z));
        Vec3 light = eye.plus(new Vec3(0.3, 0.2, -2.6));
        Vec3 to = light.minus(p);
        return 0.3 * to.normalized().z() / to.dot(to);
    }
}
