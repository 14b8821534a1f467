package lightning.editor.document;

import java.util.Optional;
import lightning.base.math.Ray;
import lightning.base.math.Vec3;
import lightning.render.trace.Geometry;
import lightning.render.trace.MaterialTable;
import lightning.render.trace.SurfacePoint;
import lightning.scene.Light;
import lightning.scene.Scene;

/** Finds what lies under a place of a canvas. Made once for all scenes that differ in lights and materials only. */
public final class ScenePicker {
    /** Of the distance from the eye. */
    private static final double OFF_SURFACE = 1e-5;

    private final Scene scene;
    private final Geometry geometry;

    public ScenePicker(Scene scene) {
        this(scene, new Geometry(scene));
    }

    /** The picker of a scene, made of a geometry as far as that serves. */
    public static ScenePicker of(Scene scene, Geometry geometry) {
        return new ScenePicker(scene, geometry.forScene(scene, geometry.castsReflections()));
    }

    private ScenePicker(Scene scene, Geometry geometry) {
        this.scene = scene;
        this.geometry = geometry;
    }

    /** The picker of another scene, made of this one's as far as that serves. */
    public ScenePicker forScene(Scene other) {
        return isValidFor(other) ? this : new ScenePicker(other, geometry.forScene(other, MaterialTable.CASTS_REFLECTIONS));
    }

    /**
     * What was found.
     *
     * @param shape  its name
     * @param point  on its surface, in the scene
     * @param normal of length 1, on the side of the eye
     * @param eye    from where it was seen
     */
    public record SurfaceHit(String shape, Vec3 point, Vec3 normal, Vec3 eye) {}

    /** Whether it finds what is in {@code other} too. */
    public boolean isValidFor(Scene other) {
        return geometry.canServe(other) && scene.camera().equals(other.camera()) && scene.picture().equals(other.picture());
    }

    /** The surface nearest to the eye of a view under a place; empty where there is none. */
    public Optional<SurfaceHit> pick(PreviewCamera view, Viewport canvas, Viewport.Pixel point) {
        Vec3 eye = view.camera().from();
        Ray ray = new Ray(geometry.toRenderSpace(eye), canvas.direction(view, point.x(), point.y()));
        // The eye may lie outside the scene's box, where the tree of boxes promises nothing.
        return toHit(geometry.nearestLinear(ray), ray, eye);
    }

    /** What stands between a place of a surface and a light, the nearest to the surface; empty where nothing does. */
    public Optional<SurfaceHit> findOccluder(SurfaceHit surface, Light light) {
        boolean isDirectional = !light.type().hasPosition();
        Vec3 toLight = isDirectional ? light.direction().negated() : light.position().minus(surface.point());
        // The ray leaves the surface from a little above it, so as not to meet that again.
        double offset = OFF_SURFACE * surface.point().minus(surface.eye()).length();
        Vec3 from = surface.point().plus(surface.normal().times(offset));
        Ray ray = new Ray(geometry.toRenderSpace(from), toLight.normalized());
        return toHit(geometry.nearest(ray), ray, from).filter(f -> isDirectional || f.point().minus(from).length() < toLight.length());
    }

    private Optional<SurfaceHit> toHit(int shape, Ray ray, Vec3 eye) {
        if (shape < 0) {
            return Optional.empty();
        }
        SurfacePoint at = geometry.surface(shape, ray);
        Vec3 point = geometry.toScene(new Vec3(at.px(), at.py(), at.pz()));
        return Optional.of(new SurfaceHit(geometry.shape(shape).name(), point, new Vec3(at.nx(), at.ny(), at.nz()).normalized(), eye));
    }

    /** The surface in the middle of the traced picture's pixel (x, y), by the tree of boxes; empty where there is none. */
    public Optional<SurfaceHit> pickPixel(int x, int y) {
        var canvas = new Viewport(scene.picture().width(), scene.picture().height());
        var view = PreviewCamera.of(scene);
        Vec3 eye = view.camera().from();
        Ray ray = new Ray(geometry.toRenderSpace(eye), canvas.direction(view, x + 0.5, y + 0.5));
        return toHit(geometry.nearest(ray), ray, eye);
    }
}
