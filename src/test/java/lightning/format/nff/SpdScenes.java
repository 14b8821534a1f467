package lightning.format.nff;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.SplittableRandom;
import lightning.base.math.Transform;
import lightning.base.math.Vec3;

/**
 * Standard procedural databases (Haines, A proposal for standard graphics environments, IEEE Computer Graphics and
 * Applications 7(11), 1987) in small sizes as NFF text, generated from their published definitions.
 */
public final class SpdScenes {
    private static final double GOLD = (1 + Math.sqrt(5)) / 2;

    private final StringBuilder out = new StringBuilder();

    private SpdScenes(String from, String at, String up, double angle) {
        appendLine("v\nfrom %s\nat %s\nup %s\nangle %s\nhither 1\nresolution 64 64", from, at, up, angle);
    }

    private void appendLine(String format, Object... arguments) {
        out.append(String.format(Locale.ROOT, format, arguments)).append('\n');
    }

    private static String text(Vec3 p) {
        return String.format(Locale.ROOT, "%.7g %.7g %.7g", p.x(), p.y(), p.z());
    }

    private void appendPolygon(List<Vec3> corners) {
        appendLine("p %d", corners.size());
        corners.forEach(c -> appendLine("%s", text(c)));
    }

    private void appendCone(Vec3 base, double baseRadius, Vec3 apex, double apexRadius) {
        appendLine("c\n%s %.6g\n%s %.6g", text(base), baseRadius, text(apex), apexRadius);
    }

    /** Sphere flake: nine spheres of a third of the size on each sphere. */
    public static String balls(int depth) {
        var scene = new SpdScenes("2.1 1.3 1.7", "0 0 0", "0 0 1", 45);
        scene.appendLine("b 0.078 0.361 0.753\nl 4 3 2\nl 1 -4 4\nl -3 1 5");
        scene.appendLine("f 1 0.75 0.33 1 0 0 0 0");
        scene.appendPolygon(List.of(new Vec3(12, 12, -0.5), new Vec3(-12, 12, -0.5), new Vec3(-12, -12, -0.5), new Vec3(12, -12, -0.5)));
        scene.appendLine("f 1 0.9 0.7 0.5 0.5 3 0 0");
        scene.appendFlake(depth, Vec3.ZERO, 0.5, new Vec3(0, 0, 1));
        return scene.out.toString();
    }

    private void appendFlake(int depth, Vec3 center, double radius, Vec3 up) {
        appendLine("s %s %.7g", text(center), radius);
        if (depth == 0) {
            return;
        }
        Vec3 side = (Math.abs(up.x()) < 0.9 ? new Vec3(1, 0, 0) : Vec3.Y).cross(up).normalized();
        Vec3 third = up.cross(side);
        for (int i = 0; i < 9; i++) {
            // Six around the middle, three above.
            double angle = Math.toRadians(i < 6 ? 60 * i : 120 * i + 30);
            double elevation = Math.toRadians(i < 6 ? 0 : 54.7356);
            Vec3 out = up.times(Math.sin(elevation)).plus(side.times(Math.cos(elevation) * Math.cos(angle))).plus(
                    third.times(Math.cos(elevation) * Math.sin(angle)));
            appendFlake(depth - 1, center.plus(out.times(radius * 4 / 3)), radius / 3, out);
        }
    }

    /** Gear wheels, originally of glass: concave polygons with many corners. */
    public static String gears(int teeth) {
        var scene = new SpdScenes("-1.1 -2.1 2.6", "0 0 0", "0 0 1", 45);
        scene.appendLine("b 0.078 0.361 0.753\nl 2 4 4 0.577 0.577 0.577\nl -2 4 3 0.577 0.577 0.577 # the second");
        scene.appendLine("f 0.1 0.5 1 0.3 0.4 60 0.9 1.5");
        List<Vec3> low = new ArrayList<>();
        for (int i = 0; i < 4 * teeth; i++) {
            double angle = 2 * Math.PI * i / (4 * teeth);
            double radius = i % 4 < 2 ? 1 : 0.8;
            low.add(new Vec3(radius * Math.cos(angle), radius * Math.sin(angle), -0.1));
        }
        List<Vec3> high = low.stream().map(p -> new Vec3(p.x(), p.y(), 0.1)).toList();
        scene.appendPolygon(high);
        scene.appendPolygon(low.reversed());
        for (int i = 0; i < low.size(); i++) {
            int next = (i + 1) % low.size();
            scene.appendPolygon(List.of(low.get(i), low.get(next), high.get(next), high.get(i)));
        }
        return scene.out.toString();
    }

    /** Fractal mountain: a recursively subdivided height field, with four glass spheres in front. */
    public static String mountain(int depth) {
        var scene = new SpdScenes("-1.6 1.6 1.7", "0 0 0", "0 0 1", 45);
        scene.appendLine("b 0.078 0.361 0.753\nl -100 -100 100");
        scene.appendLine("f 0.5 0.45 0.35 1 0 0 0 0");
        int n = 1 << depth;
        var random = new SplittableRandom(1987);
        double[][] height = new double[n + 1][n + 1];
        for (int step = n; step > 1; step /= 2) {
            for (int x = 0; x <= n; x += step / 2) {
                for (int y = 0; y <= n; y += step / 2) {
                    if (x % step != 0 || y % step != 0) {
                        int left = x - x % step;
                        int low = y - y % step;
                        int right = x % step == 0 ? left : left + step;
                        int high = y % step == 0 ? low : low + step;
                        height[x][y] = (height[left][low] + height[right][high]) / 2 + (random.nextDouble() - 0.5) * step / n;
                    }
                }
            }
        }
        for (int x = 0; x < n; x++) {
            for (int y = 0; y < n; y++) {
                Vec3 a = vertexText(height, n, x, y);
                Vec3 c = vertexText(height, n, x + 1, y + 1);
                scene.appendPolygon(List.of(a, vertexText(height, n, x + 1, y), c));
                scene.appendPolygon(List.of(a, c, vertexText(height, n, x, y + 1)));
            }
        }
        scene.appendLine("f 1 0.9 0.7 0 0.9 50 0.9 1.5");
        for (int i = 0; i < 4; i++) {
            scene.appendLine("s %s %s 1.2 0.25", i % 2 - 0.5, i / 2 - 0.5);
        }
        return scene.out.toString();
    }

    private static Vec3 vertexText(double[][] height, int n, int x, int y) {
        return new Vec3(2.0 * x / n - 1, 2.0 * y / n - 1, height[x][y] / 2);
    }

    /** Pyramid of dodecahedral rings: spheres at the twenty corners, cylinders along the thirty edges. */
    public static String rings() {
        var scene = new SpdScenes("5 -8 4", "0 0 0", "0 0 1", 30);
        scene.appendLine("b 0.078 0.361 0.753\nl 10 -10 15\nl -10 -15 10\nl 0 0 20");
        scene.appendLine("f 1 0.75 0.33 0.8 0 0 0 0");
        scene.appendPolygon(List.of(new Vec3(9, 9, -3), new Vec3(-9, 9, -3), new Vec3(-9, -9, -3), new Vec3(9, -9, -3)));
        scene.appendLine("f 0.5 0.2 0.9 0.5 0.3 20 0 0");
        List<Vec3> corners = new ArrayList<>();
        for (int i = 0; i < 8; i++) {
            corners.add(new Vec3((i & 1) * 2 - 1, (i >> 1 & 1) * 2 - 1, (i >> 2 & 1) * 2 - 1));
        }
        for (int i = 0; i < 4; i++) {
            double a = ((i & 1) * 2 - 1) / GOLD;
            double b = ((i >> 1 & 1) * 2 - 1) * GOLD;
            corners.addAll(List.of(new Vec3(0, a, b), new Vec3(a, b, 0), new Vec3(b, 0, a)));
        }
        for (int i = 0; i < corners.size(); i++) {
            scene.appendLine("s %s 0.25", text(corners.get(i)));
            for (int j = 0; j < i; j++) {
                if (corners.get(i).minus(corners.get(j)).length() < 2 / GOLD + 1e-6) {
                    scene.appendCone(corners.get(i), 0.125, corners.get(j), 0.125);
                }
            }
        }
        return scene.out.toString();
    }

    /** Recursive tetrahedron, with four of half the size in each. */
    public static String tetra(int depth) {
        var scene = new SpdScenes("1.02 1.55 -1.28", "0 0.05 0", "0 1 0", 45);
        scene.appendLine("b 0.078 0.361 0.753\nl 1.9 3.5 -2.5\nf 1 0.2 0.2 1 0 0 0 0");
        scene.appendTetrahedra(depth, Vec3.ZERO, 1);
        return scene.out.toString();
    }

    private void appendTetrahedra(int depth, Vec3 center, double size) {
        List<Vec3> corners = List.of(new Vec3(1, 1, 1), new Vec3(1, -1, -1), new Vec3(-1, 1, -1), new Vec3(-1, -1, 1)).stream()
                .map(c -> center.plus(c.times(size))).toList();
        if (depth > 0) {
            corners.forEach(c -> appendTetrahedra(depth - 1, center.plus(c).times(0.5), size / 2));
            return;
        }
        for (int i = 0; i < 4; i++) {
            appendPolygon(List.of(corners.get(i % 4), corners.get((i + 1) % 4), corners.get((i + 2) % 4)));
        }
    }

    /** Tree: each branch is a cone with a sphere at its end, from which three smaller branches grow. */
    public static String tree(int depth) {
        var scene = new SpdScenes("4.5 0.4 2", "0 0 1.5", "0 0 1", 45);
        scene.appendLine("b 0.078 0.361 0.753\nl -5 5 50\nl 30 -30 30\nl -40 -30 20\nl 10 30 40\nl -30 40 10\nl 50 25 10\nl -10 -60 30");
        scene.appendLine("f 0.7 0.7 0.7 0.9 0 0 0 0");
        scene.appendPolygon(List.of(new Vec3(50, 50, 0), new Vec3(-50, 50, 0), new Vec3(-50, -50, 0), new Vec3(50, -50, 0)));
        scene.appendLine("f 0.55 0.4 0.2 1 0 0 0 0");
        scene.appendBranch(depth, Transform.IDENTITY);
        return scene.out.toString();
    }

    private void appendBranch(int depth, Transform transform) {
        double size = transform.transformVector(new Vec3(0, 0, 1)).length();
        Vec3 top = transform.transformPoint(new Vec3(0, 0, 1));
        appendCone(transform.transformPoint(Vec3.ZERO), 0.1 * size, top, 0.07 * size);
        appendLine("s %s %.7g", text(top), 0.07 * size);
        for (int i = 0; i < 3 && depth > 0; i++) {
            appendBranch(depth - 1,
                    transform.times(Transform.translation(new Vec3(0, 0, 1))).times(Transform.rotation(new Vec3(0, 0, 120 * i + 20)))
                            .times(Transform.rotation(new Vec3(40, 0, 0))).times(Transform.scaling(new Vec3(0.7, 0.7, 0.7))));
        }
    }
}
