package lightning.editor.window.property;

import java.util.Optional;
import javafx.beans.value.ObservableValue;
import lightning.base.text.Messages;
import lightning.editor.EditorState;
import lightning.editor.window.model.EditorModel;
import lightning.scene.Camera;
import lightning.scene.LensAttributes;
import lightning.scene.SceneElement;
import lightning.scene.attribute.SceneAttribute;

/** Lens of the camera: aperture and, while it is open, focus and blades. */
final class LensForm extends AttributeForm<Camera> {
    LensForm(EditorModel model, ObservableValue<EditorState> visibleState) {
        super(model, null);
        getStyleClass().add("section-rows");
        getChildren().addAll(SectionLayout.nodes(numbers(LensAttributes.APERTURE),
                columnIf(camera -> camera.lens().isOpen(), numbers(LensAttributes.FOCUS), numbers(LensAttributes.BLADES),
                        numbers(LensAttributes.ROTATION))));
        showWhile(visibleState);
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
        return "camera-" + attribute.name();
    }

    @Override
    String label(SceneAttribute<Camera, ?> attribute, String part) {
        return attribute == LensAttributes.APERTURE ? Messages.tr("Aperture radius")
                : attribute == LensAttributes.FOCUS ? Messages.tr("Focus distance")
                : attribute == LensAttributes.BLADES ? Messages.tr("Blades") : Messages.tr("Blade rotation");
    }
}
