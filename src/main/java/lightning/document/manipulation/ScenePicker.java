package lightning.document.manipulation;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import lightning.base.math.Ray;
import lightning.base.math.Vec3;
import lightning.render.trace.Geometry;
import lightning.render.trace.MaterialTable;
import lightning.render.trace.SurfacePoint;
import lightning.scene.Scene;
import lightning.scene.light.Light;
import lightning.scene.value.ShapeLinks;

/** Ray-cast picking of surfaces. Shared by all scenes that differ only in lights and materials. */
public final class ScenePicker {
    /** Offset from the surface, as a share of the distance from the camera. */
    private static final double OFF_SURFACE = 1e-5;

    private final Scene scene;
    private final Geometry geometry;

    public ScenePicker(Scene scene) {
        this(scene, Geometry.of(scene));
    }

    /** Returns the picker of a scene, reusing a geometry if possible. */
    public static ScenePicker of(Scene scene, Geometry geometry) {
        return new ScenePicker(scene, geometry.forScene(scene, geometry.castsReflections()));
    }

    private ScenePicker(Scene scene, Geometry geometry) {
        this.scene = scene;
        this.geometry = geometry;
    }

    /** Returns the picker of another scene, reusing this one's geometry if possible. */
    public ScenePicker forScene(Scene other) {
        return isValidFor(other) ? this : new ScenePicker(other, geometry.forScene(other, MaterialTable.CASTS_REFLECTIONS));
    }

    /**
     * Picked surface point.
     *
     * @param shape  name of the shape, or of the light whose face it is
     * @param point  point on its surface, in the scene
     * @param normal unit normal on the side of the eye
     * @param eye    origin of the pick ray
     */
    public record SurfaceHit(String shape, Vec3 point, Vec3 normal, Vec3 eye) {}

    /** Returns whether it is valid for {@code other} too. */
    public boolean isValidFor(Scene other) {
        return geometry.canServe(other) && scene.camera().equals(other.camera()) && scene.picture().equals(other.picture());
    }

    /** Returns the surface nearest to the camera under a position; empty if none. */
    public Optional<SurfaceHit> pick(PreviewCamera view, Viewport canvas, Viewport.Pixel point) {
        Vec3 eye = view.camera().from();
        Ray ray = new Ray(geometry.toRenderSpace(eye), canvas.direction(view, point.x(), point.y()));
        // The camera may be outside the scene's bounds, where the BVH is not valid.
        return toHit(geometry.nearestLinear(ray), ray, eye);
    }

    /** Returns the first occluder between a surface point and a light; empty if the light is visible. */
    public Optional<SurfaceHit> findOccluder(SurfaceHit surface, Light light) {
        boolean isDirectional = !light.type().hasPosition();
        Vec3 toLight = isDirectional ? light.direction().negated() : light.position().minus(surface.point());
        return occluders(surface, toLight.normalized(), light.shadowCasters(), 1).stream()
                .filter(f -> isDirectional || f.point().minus(f.eye()).length() < toLight.length()).findFirst();
    }

    /**
     * Returns the surfaces that cast shadows from a light on a surface point, nearest first. Faces of lights and materials without shadows do
     * not.
     *
     * @param direction unit direction from the point
     * @param casters   shapes that cast shadows from the light
     * @param max       largest number of surfaces
     */
    List<SurfaceHit> occluders(SurfaceHit surface, Vec3 direction, ShapeLinks casters, int max) {
        Geometry shadowing = geometry.shadowGeometry(casters);
        List<SurfaceHit> found = new ArrayList<>();
        // Offset from the surface to avoid self-intersection.
        double offset = OFF_SURFACE * surface.point().minus(surface.eye()).length();
        Vec3 from = surface.point().plus(surface.normal().times(offset));
        Optional<SurfaceHit> next = shadowing.castsShadows() ? nearest(shadowing, from, direction, from) : Optional.empty();
        while (next.isPresent() && found.size() < max) {
            found.add(next.get());
            next = nearest(shadowing, next.get().point().plus(direction.times(offset)), direction, from);
        }
        return found;
    }

    private Optional<SurfaceHit> nearest(Geometry shapes, Vec3 origin, Vec3 direction, Vec3 eye) {
        Ray ray = new Ray(geometry.toRenderSpace(origin), direction);
        return toHit(shapes.nearest(ray), ray, eye);
    }

    private Optional<SurfaceHit> toHit(int shape, Ray ray, Vec3 eye) {
        if (shape < 0) {
            return Optional.empty();
        }
        SurfacePoint at = geometry.surface(shape, ray);
        Vec3 point = geometry.toScene(new Vec3(at.px(), at.py(), at.pz()));
        return Optional.of(new SurfaceHit(geometry.shape(shape).name(), point, new Vec3(at.nx(), at.ny(), at.nz()).normalized(), eye));
    }

    /** Returns the surface at the center of the traced image's pixel (x, y), using the BVH; empty if none. */
    public Optional<SurfaceHit> pickPixel(int x, int y) {
        var canvas = new Viewport(scene.picture().width(), scene.picture().height());
        var view = PreviewCamera.of(scene);
        Vec3 eye = view.camera().from();
        Ray ray = new Ray(geometry.toRenderSpace(eye), canvas.direction(view, x + 0.5, y + 0.5));
        return toHit(geometry.nearest(ray), ray, eye);
    }
}
