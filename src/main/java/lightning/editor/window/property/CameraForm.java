package lightning.editor.window.property;

import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import javafx.beans.value.ObservableValue;
import lightning.base.math.Transform;
import lightning.base.math.Vec3;
import lightning.base.text.Messages;
import lightning.editor.EditorState;
import lightning.editor.window.model.EditorModel;
import lightning.scene.Camera;
import lightning.scene.LensAttributes;
import lightning.scene.SceneElement;
import lightning.scene.attribute.NumericKind;
import lightning.scene.attribute.SceneAttribute;
import lightning.scene.value.SceneLimits;

/** The scene's camera: its place and its angle, or its lens. */
final class CameraForm extends AttributeForm<Camera> {
    /** Half the height of a 35 mm film, millimeters. */
    private static final double HALF_FILM = 12;

    private static final SceneAttribute<Camera, Double> ROLL =
            new SceneAttribute<>("roll", Messages.key("roll"), NumericKind.degrees(-180, 180, 1), 0.0,
                    "degrees, clockwise", CameraForm::roll, CameraForm::withRoll);
    private static final SceneAttribute<Camera, Double> FOCAL_LENGTH = new SceneAttribute<>("focal_length", Messages.key("focal length"),
            NumericKind.number(focalLength(SceneLimits.MAX_FOV), focalLength(SceneLimits.MIN_FOV), 1), focalLength(Camera.DEFAULT.fov()),
            "millimeters, for a film 24 mm high", camera -> focalLength(camera.fov()),
            (camera, length) -> Camera.FOV.with(camera,
                    Math.clamp(2 * Math.toDegrees(Math.atan(HALF_FILM / length)), SceneLimits.MIN_FOV, SceneLimits.MAX_FOV)));

    private CameraForm(EditorModel model, ObservableValue<EditorState> visibleState) {
        super(model, null);
        getStyleClass().add("section-rows");
        showWhile(visibleState);
    }

    /** Returns a form for place, target, angle and shift. */
    static CameraForm view(EditorModel model, ObservableValue<EditorState> visibleState) {
        var form = new CameraForm(model, visibleState);
        form.getChildren().addAll(SectionLayout.nodes(form.rows(Camera.FROM), form.rows(Camera.TO),
                Stream.of(ROLL, FOCAL_LENGTH, Camera.FOV, Camera.SHIFT).flatMap(a -> form.numbers(a).stream()).toList()));
        return form;
    }

    /** Returns a form for the aperture and, while it is open, focus and blades. */
    static CameraForm lens(EditorModel model, ObservableValue<EditorState> visibleState) {
        var form = new CameraForm(model, visibleState);
        form.getChildren().addAll(SectionLayout.nodes(form.numbers(LensAttributes.APERTURE),
                form.columnIf(camera -> camera.lens().isOpen(), form.numbers(LensAttributes.FOCUS), form.numbers(LensAttributes.BLADES),
                        form.numbers(LensAttributes.ROTATION))));
        return form;
    }

    private static double focalLength(double fov) {
        return HALF_FILM * Transform.cosDegrees(fov / 2) / Transform.sinDegrees(fov / 2);
    }

    /** Returns the directions to the right and up in a picture whose camera has no roll: upright or, straight from above or below, with −z up. */
    private static List<Vec3> unrolled(Camera camera) {
        Vec3 forward = camera.to().minus(camera.from()).normalized();
        Vec3 right = forward.cross(Vec3.Y);
        Vec3 side = (right.length() > 1e-6 ? right : forward.cross(new Vec3(0, 0, -1))).normalized();
        return List.of(side, side.cross(forward));
    }

    private static double roll(Camera camera) {
        List<Vec3> axes = unrolled(camera);
        return Math.toDegrees(Math.atan2(camera.up().dot(axes.get(0)), camera.up().dot(axes.get(1))));
    }

    private static Camera withRoll(Camera camera, double roll) {
        List<Vec3> axes = unrolled(camera);
        return camera.withView(camera.from(), camera.to(),
                axes.get(1).times(Transform.cosDegrees(roll)).plus(axes.get(0).times(Transform.sinDegrees(roll))));
    }

    @Override
    Optional<SceneElement<Camera>> selected() {
        return Optional.of(SceneElement.CAMERA);
    }

    @Override
    String missingReason() {
        return "";
    }

    @Override
    String id(SceneAttribute<Camera, ?> attribute, String part) {
        return "camera-" + attribute.name().replace('_', '-') + (part.isEmpty() ? "" : "-" + part);
    }

    @Override
    String label(SceneAttribute<Camera, ?> attribute, String part) {
        return switch (attribute.name()) {
            case "from" -> Messages.tr("Position");
            case "to" -> Messages.tr("Target");
            case "roll" -> Messages.tr("Roll");
            case "focal_length" -> Messages.tr("Focal length (mm)");
            case "fov" -> Messages.tr("Vertical angle");
            case "shift" -> "x".equals(part) ? Messages.tr("Lens shift x") : Messages.tr("Lens shift y");
            case "aperture" -> Messages.tr("Aperture radius");
            case "focus" -> Messages.tr("Focus distance");
            case "blades" -> Messages.tr("Blades");
            default -> Messages.tr("Blade rotation");
        };
    }
}
