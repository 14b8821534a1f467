package lightning.sample;

import lightning.base.math.Vec3;
import lightning.scene.Camera;
import lightning.scene.Scene;
import lightning.scene.light.AreaShape;
import lightning.scene.light.Light;
import lightning.scene.value.SceneLimits;

/**
 * Light before its placement in a scene.
 *
 * @param attributes all attributes except name, position and direction
 * @param at         position
 * @param aim        target
 */
record LightTemplate(Light attributes, RelativePosition at, RelativePosition aim) {

    /** Returns the light with the given name. */
    Light instantiate(Scene scene, String name) {
        Vec3 position = at.in(scene);
        return attributes.withName(name).withPosition(position).withDirection(direction(position, aim.in(scene)))
                .withArea(scaleArea(attributes.area(), scene.camera()))
                .retainLinks(scene.stage()::hasNode);
    }

    /** Sizes assume a camera 7 units away from its target. */
    private static AreaShape scaleArea(AreaShape area, Camera camera) {
        double unit = camera.from().minus(camera.to()).length() / 7;
        return area.withRadius(length(unit, area.radius())).withWidth(length(unit, area.width())).withHeight(length(unit, area.height()));
    }

    private static double length(double unit, double length) {
        return Math.min(unit * length, SceneLimits.MAX_EXTENT);
    }

    /** Returns the direction to the target; down if both coincide. */
    static Vec3 direction(Vec3 from, Vec3 to) {
        Vec3 direction = to.minus(from);
        return direction.maxAbs() < 1e-12 ? new Vec3(0, -1, 0) : direction;
    }
}
