package lightning.edit;

import lightning.math.Vec3;
import lightning.scene.Light;
import lightning.scene.Scene;

/**
 * Places a light by what it does in the picture: its highlight or a shadow falls where the artist points. The light keeps
 * its distance from there; where it has a direction it is turned to shine there.
 */
public final class LightPlacing {
    private LightPlacing() {}

    /** The highlight: the light goes where the view is mirrored to at that point (V·R = 1 in paper §2.2). */
    public static Change highlight(Scene scene, String light, ScenePicker.Found at) {
        return LightEdits.with(scene, light, l -> {
            Vec3 view = at.point().minus(at.eye()).normalized();
            Vec3 mirrored = view.minus(at.normal().times(2 * view.dot(at.normal())));
            return shiningFrom(l, at.point(), mirrored);
        });
    }

    /**
     * The shadow: the light goes behind a point of what throws it, as seen from where the shadow shall fall.
     *
     * @param thrower a point in the middle of what throws the shadow
     * @param target  where the shadow shall fall; refused if it is the same point
     */
    public static Change shadow(Scene scene, String light, Vec3 thrower, Vec3 target) {
        return LightEdits.with(scene, light, l -> {
            Vec3 way = thrower.minus(target);
            if (!(way.maxAbs() >= 1e-9)) {
                throw new IllegalArgumentException("the shadow falls on what throws it");
            }
            boolean tooNear = l.type().hasPosition() && l.position().minus(target).length() <= way.length();
            Vec3 nearest = target.plus(way.times(2));
            return shiningFrom(tooNear ? l.withPosition(nearest) : l, target, way.normalized());
        });
    }

    private static Light shiningFrom(Light light, Vec3 target, Vec3 towardsLight) {
        double distance = light.position().minus(target).length();
        Light placed = light.type().hasPosition() ? light.withPosition(target.plus(towardsLight.times(distance))) : light;
        return light.type().hasDirection()
                ? placed.withDirection(towardsLight.times(-light.direction().length())) : placed;
    }
}
