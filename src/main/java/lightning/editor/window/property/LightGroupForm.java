package lightning.editor.window.property;

import java.util.Optional;
import javafx.beans.value.ObservableValue;
import javafx.scene.Node;
import lightning.base.text.Messages;
import lightning.editor.EditorState;
import lightning.editor.window.model.EditorModel;
import lightning.scene.SceneElement;
import lightning.scene.attribute.SceneAttribute;
import lightning.scene.light.LightGroup;

/** Master and gel of the selected light's group, below the choice of the group. */
final class LightGroupForm extends AttributeForm<LightGroup> {

    /** @param groupBox  box that chooses the light's group */
    LightGroupForm(EditorModel model, Node groupBox, ObservableValue<EditorState> visibleState) {
        super(model, null);
        getStyleClass().add("section-content");
        getChildren().add(groupBox);
        getChildren().addAll(numbers(LightGroup.INTENSITY));
        getChildren().addAll(titled(LightGroup.COLOR, color(LightGroup.COLOR)));
        showWhile(visibleState);
    }

    @Override
    Optional<SceneElement<LightGroup>> selected() {
        return Optional.ofNullable(editor.selection().light()).filter(light -> !light.lightGroup().isEmpty())
                .map(light -> new SceneElement.OfLightGroup(light.lightGroup()));
    }

    @Override
    String missingReason() {
        return Messages.tr("the light is in no light group");
    }

    @Override
    String id(SceneAttribute<LightGroup, ?> attribute, String part) {
        return title(attribute);
    }

    @Override
    String title(SceneAttribute<LightGroup, ?> attribute) {
        return attribute == LightGroup.COLOR ? "gel" : "master";
    }

    @Override
    String label(SceneAttribute<LightGroup, ?> attribute, String part) {
        return attribute == LightGroup.COLOR ? Messages.tr("Gel") : Messages.tr("Master");
    }

    @Override
    String help(SceneAttribute<LightGroup, ?> attribute) {
        return Messages.tr("Multiplies the color of every light in the group");
    }
}
