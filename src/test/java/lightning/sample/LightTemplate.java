package lightning.sample;

import lightning.base.math.Vec3;
import lightning.scene.AreaShape;
import lightning.scene.Camera;
import lightning.scene.Light;
import lightning.scene.Scene;
import lightning.scene.SceneLimits;

/**
 * A light yet to be put into a scene.
 *
 * @param attributes all but name, position and direction
 * @param at         where it stands
 * @param aim        what it shines at
 */
record LightTemplate(Light attributes, RelativePosition at, RelativePosition aim) {

    /** The light of the given name. */
    Light instantiate(Scene scene, String name) {
        Vec3 position = at.in(scene);
        return attributes.withName(name).withPosition(position).withDirection(direction(position, aim.in(scene)))
                .withArea(scaleArea(attributes.area(), scene.camera()))
                .withIlluminates(attributes.illuminates().retain(scene.stage()::hasNode))
                .withShadowedBy(attributes.shadowedBy().retain(scene.stage()::hasNode));
    }

    /** Sizes are told for a camera 7 units away from what it looks at. */
    private static AreaShape scaleArea(AreaShape area, Camera camera) {
        double unit = camera.from().minus(camera.to()).length() / 7;
        return area.withRadius(length(unit, area.radius())).withWidth(length(unit, area.width())).withHeight(length(unit, area.height()));
    }

    private static double length(double unit, double length) {
        return Math.min(unit * length, SceneLimits.MAX_EXTENT);
    }

    /** The direction to what is aimed at; down where there is none. */
    static Vec3 direction(Vec3 from, Vec3 to) {
        Vec3 direction = to.minus(from);
        return direction.maxAbs() < 1e-12 ? new Vec3(0, -1, 0) : direction;
    }
}
