package lightning.editor.window.property;

import java.util.List;
import java.util.Optional;
import javafx.beans.value.ObservableValue;
import javafx.scene.Node;
import javafx.scene.control.ToggleButton;
import lightning.base.text.Messages;
import lightning.document.EditOutcome;
import lightning.editor.Command;
import lightning.editor.EditorState;
import lightning.editor.window.command.CommandButton;
import lightning.editor.window.model.EditorModel;
import lightning.scene.IndirectSettings;
import lightning.scene.SceneElement;
import lightning.scene.attribute.SceneAttribute;

/** Settings of the scene's indirect light, shown only while it is on. */
final class IndirectForm extends AttributeForm<IndirectSettings> {
    private final ToggleButton on = new ToggleButton();
    private final Node rows;

    IndirectForm(EditorModel model, ObservableValue<EditorState> visibleState) {
        super(model, null);
        getStyleClass().add("section-rows");
        on.setId("world-indirect");
        on.setAccessibleText(Messages.tr("Indirect Light"));
        on.setMaxWidth(Double.MAX_VALUE);
        on.setOnAction(_ -> {
            Optional<IndirectSettings> settings = on.isSelected() ? Optional.of(IndirectSettings.INITIAL) : Optional.empty();
            editor.editOrReport(scene -> EditOutcome.edit(scene, SceneElement.PICTURE, picture -> picture.withIndirect(settings)));
        });
        rows = SectionLayout.column(numbers(IndirectSettings.BOUNCES),
                titled(IndirectSettings.RAYS, choice(IndirectSettings.RAYS, _ -> IndirectSettings.RAY_COUNTS, String::valueOf)),
                numbers(IndirectSettings.SPACING), rows(IndirectSettings.BACKGROUND),
                List.of(CommandButton.titledButton(model.commands(), Command.COMPARE_SETTINGS)));
        getChildren().addAll(on, rows);
        showWhile(visibleState);
    }

    @Override
    Optional<SceneElement<IndirectSettings>> selected() {
        return Optional.of(SceneElement.INDIRECT);
    }

    @Override
    String missingReason() {
        return Messages.tr("indirect light is off");
    }

    @Override
    void show() {
        boolean isOn = record().isPresent();
        on.setSelected(isOn);
        on.setText(isOn ? Messages.tr("On") : Messages.tr("Off"));
        SectionLayout.setShown(rows, isOn);
        super.show();
    }

    @Override
    String id(SceneAttribute<IndirectSettings, ?> attribute, String part) {
        return "world-indirect-" + attribute.name();
    }

    @Override
    String title(SceneAttribute<IndirectSettings, ?> attribute) {
        return attribute == IndirectSettings.RAYS ? label(attribute, "") : attribute.title();
    }

    @Override
    String label(SceneAttribute<IndirectSettings, ?> attribute, String part) {
        return attribute == IndirectSettings.BOUNCES ? Messages.tr("Bounces")
                : attribute == IndirectSettings.RAYS ? Messages.tr("Rays per Gather Point")
                : attribute == IndirectSettings.SPACING ? Messages.tr("Gather Point Spacing") : Messages.tr("Light from Background");
    }
}
