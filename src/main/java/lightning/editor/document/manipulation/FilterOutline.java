package lightning.editor.document.manipulation;

import java.util.ArrayList;
import java.util.List;
import lightning.base.math.Transform;
import lightning.base.math.Vec3;
import lightning.editor.document.manipulation.LightGizmo.Segment;
import lightning.scene.light.FilterShape;
import lightning.scene.light.Light;
import lightning.scene.value.Fog;

/** Outlines at true size of a light's flag and filter, and of the box of fog, in the scene. */
final class FilterOutline {
    private static final int SIDES = 24;

    private FilterOutline() {}

    /** Returns the lines; none without a flag and a filter. */
    static List<Segment> of(Light light) {
        List<Segment> lines = new ArrayList<>();
        if (light.flag().on()) {
            Place place = new Place(light.flag().position(), light.flag().rotation(),
                    new Vec3(light.flag().width(), light.flag().height(), 0));
            lines.addAll(polygon(List.of(place.at(-1, -1, 0), place.at(1, -1, 0), place.at(1, 1, 0), place.at(-1, 1, 0))));
            lines.add(new Segment(place.at(-1, -1, 0), place.at(1, 1, 0)));
            lines.add(new Segment(place.at(-1, 1, 0), place.at(1, -1, 0)));
        }
        if (light.filter().isActive()) {
            Place place = new Place(light.filter().position(), light.filter().rotation(), light.filter().size());
            lines.addAll(light.filter().shape() == FilterShape.SPHERE ? sphere(place) : box(place));
        }
        return lines;
    }

    /** Returns the box of a fog; none if the fog has no box. */
    static List<Segment> of(Fog fog) {
        return fog.isPresent() && fog.hasBox() ? box(new Place(fog.center(), Vec3.ZERO, fog.size())) : List.of();
    }

    private record Place(Vec3 center, Vec3 rotation, Vec3 size) {
        /** Returns a point at a share of the half sizes. */
        Vec3 at(double x, double y, double z) {
            return center.plus(Transform.rotation(rotation)
                    .transformVector(new Vec3(x * size.x() / 2, y * size.y() / 2, z * size.z() / 2)));
        }
    }

    private static List<Segment> box(Place place) {
        List<Segment> lines = new ArrayList<>();
        for (int a = -1; a <= 1; a += 2) {
            for (int b = -1; b <= 1; b += 2) {
                lines.add(new Segment(place.at(-1, a, b), place.at(1, a, b)));
                lines.add(new Segment(place.at(a, -1, b), place.at(a, 1, b)));
                lines.add(new Segment(place.at(a, b, -1), place.at(a, b, 1)));
            }
        }
        return lines;
    }

    private static List<Segment> sphere(Place place) {
        List<List<Vec3>> circles = List.of(new ArrayList<>(), new ArrayList<>(), new ArrayList<>());
        for (int i = 0; i < SIDES; i++) {
            double cos = Math.cos(2 * Math.PI * i / SIDES);
            double sin = Math.sin(2 * Math.PI * i / SIDES);
            circles.get(0).add(place.at(cos, sin, 0));
            circles.get(1).add(place.at(cos, 0, sin));
            circles.get(2).add(place.at(0, cos, sin));
        }
        return circles.stream().flatMap(circle -> polygon(circle).stream()).toList();
    }

    private static List<Segment> polygon(List<Vec3> points) {
        List<Segment> lines = new ArrayList<>();
        for (int i = 0; i < points.size(); i++) {
            lines.add(new Segment(points.get(i), points.get((i + 1) % points.size())));
        }
        return lines;
    }
}
