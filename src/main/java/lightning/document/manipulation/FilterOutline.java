package lightning.document.manipulation;

import java.util.ArrayList;
import java.util.List;
import lightning.base.math.Transform;
import lightning.base.math.Vec3;
import lightning.document.manipulation.LightGizmo.Segment;
import lightning.scene.light.FilterShape;
import lightning.scene.light.Light;
import lightning.scene.value.Fog;

/** Outlines at true size of a light's flag and filter, and of the box of fog, in the scene. */
public final class FilterOutline {
    private static final int SIDES = 24;

    private FilterOutline() {}

    /** Returns the lines; none without a flag and a filter. */
    public static List<Segment> of(Light light) {
        List<Segment> lines = new ArrayList<>();
        if (light.flag().on()) {
            Place place = Place.of(light.flag().position(), light.flag().rotation(),
                    new Vec3(light.flag().width(), light.flag().height(), 0));
            lines.addAll(LightGizmo.polygon(List.of(place.at(-1, -1, 0), place.at(1, -1, 0), place.at(1, 1, 0), place.at(-1, 1, 0))));
            lines.add(new Segment(place.at(-1, -1, 0), place.at(1, 1, 0)));
            lines.add(new Segment(place.at(-1, 1, 0), place.at(1, -1, 0)));
        }
        if (light.filter().isActive()) {
            Place place = Place.of(light.filter().position(), light.filter().rotation(), light.filter().size());
            lines.addAll(light.filter().shape() == FilterShape.SPHERE ? sphere(place) : box(place));
        }
        return lines;
    }

    /** Returns the box of a fog; none if the fog has no box. */
    public static List<Segment> of(Fog fog) {
        return fog.isPresent() && fog.hasBox() ? box(Place.of(fog.center(), Vec3.ZERO, fog.size())) : List.of();
    }

    /** Box around a center. */
    private record Place(Vec3 center, Transform rotation, Vec3 half) {
        static Place of(Vec3 center, Vec3 rotation, Vec3 size) {
            return new Place(center, Transform.rotation(rotation), size.times(0.5));
        }

        /** Returns a point at a share of the half sizes. */
        Vec3 at(double x, double y, double z) {
            return center.plus(rotation.transformVector(new Vec3(x * half.x(), y * half.y(), z * half.z())));
        }
    }

    private static List<Segment> box(Place place) {
        return GroupBounds.edges(corner -> place.at(2 * (corner & 1) - 1, (corner & 2) - 1, (corner & 4) / 2 - 1));
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
        return circles.stream().flatMap(circle -> LightGizmo.polygon(circle).stream()).toList();
    }
}
