package lightning.editor.document.manipulation;

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
        // Offset from the surface to avoid self-intersection.
        double offset = OFF_SURFACE * surface.point().minus(surface.eye()).length();
        Vec3 from = surface.point().plus(surface.normal().times(offset));
        Ray ray = new Ray(geometry.toRenderSpace(from), toLight.normalized());
        // Faces of lights and materials without shadows are no occluders.
        Geometry casters = geometry.shadowGeometry(ShapeLinks.ALL);
        return toHit(casters.castsShadows() ? casters.nearest(ray) : -1, ray, from)
                .filter(f -> isDirectional || f.point().minus(from).length() < toLight.length());
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
