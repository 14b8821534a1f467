package lightning.editor.window.property;

import java.util.Optional;
import java.util.function.UnaryOperator;
import javafx.beans.value.ObservableValue;
import javafx.scene.control.ComboBox;
import javafx.scene.control.ToggleButton;
import javafx.scene.layout.HBox;
import javafx.scene.layout.Priority;
import javafx.scene.layout.VBox;
import lightning.base.text.Messages;
import lightning.editor.document.Command;
import lightning.editor.document.EditOutcome;
import lightning.editor.document.EditorState;
import lightning.editor.document.StepRange;
import lightning.editor.window.command.CommandButton;
import lightning.editor.window.model.CommandRegistry;
import lightning.editor.window.model.SceneEditor;
import lightning.editor.window.widget.ArrowWidget;
import lightning.editor.window.widget.NumberSetting;
import lightning.scene.IndirectSettings;
import lightning.scene.Scene;
import lightning.scene.attribute.ChoiceKind;
import lightning.scene.attribute.NumericKind;
import lightning.scene.attribute.SceneAttribute;
import org.jspecify.annotations.Nullable;

/** Settings of the scene's indirect light, shown only while it is on. */
final class IndirectControls extends VBox {
    private final SceneEditor editor;
    private final ToggleButton on = new ToggleButton();
    private final ComboBox<Integer> rays = new ComboBox<>();
    private final ArrowWidget bounces;
    private final ArrowWidget spacing;
    private final AttributeChoiceBox<Boolean> background;
    private final VBox rows;
    private boolean isUpdating;

    /** @param visibleState  state as in {@link PropertyPane} */
    IndirectControls(SceneEditor editor, CommandRegistry commands, ObservableValue<EditorState> visibleState) {
        this.editor = editor;
        on.setId("world-indirect");
        on.setAccessibleText(Messages.tr("Indirect Light"));
        on.setMaxWidth(Double.MAX_VALUE);
        on.setOnAction(_ -> edit(_ -> on.isSelected() ? Optional.of(IndirectSettings.INITIAL) : Optional.empty(), null));
        bounces = number(Messages.tr("Bounces"), IndirectSettings.BOUNCES);
        spacing = number(Messages.tr("Gather Point Spacing"), IndirectSettings.SPACING);
        rays.setId("world-indirect-rays");
        rays.setAccessibleText(Messages.tr("Rays per Gather Point"));
        rays.setMaxWidth(Double.MAX_VALUE);
        rays.getItems().setAll(IndirectSettings.RAY_COUNTS);
        rays.valueProperty().addListener((_, _, now) -> {
            if (!isUpdating && now != null) {
                report(set(i -> i.withRays(now), null));
            }
        });
        background = new AttributeChoiceBox<>(IndirectSettings.BACKGROUND, (ChoiceKind<Boolean>) IndirectSettings.BACKGROUND.kind(), "",
                v -> report(set(i -> i.withBackground(v), null)));
        background.box().setId("world-indirect-background");
        rows = new VBox(bounces, SectionLayout.caption(Messages.tr("Rays per Gather Point")), rays, spacing,
                SectionLayout.caption(Messages.tr("Light from Background")), background,
                CommandButton.titledButton(commands, Command.COMPARE_SETTINGS));
        rows.getStyleClass().add("section-rows");
        HBox.setHgrow(on, Priority.ALWAYS);
        getStyleClass().add("section-rows");
        getChildren().addAll(on, rows);
        visibleState.subscribe(state -> show(state.scene().picture().indirect()));
    }

    private void show(Optional<IndirectSettings> settings) {
        isUpdating = true;
        on.setSelected(settings.isPresent());
        on.setText(settings.isPresent() ? Messages.tr("On") : Messages.tr("Off"));
        WorldPane.setShown(rows, settings.isPresent());
        settings.ifPresent(s -> {
            bounces.show(s.bounces());
            spacing.show(s.spacing());
            rays.setValue(s.rays());
            background.show(s.background());
        });
        isUpdating = false;
    }

    private <V> ArrowWidget number(String label, SceneAttribute<IndirectSettings, V> attribute) {
        var quantity = (NumericKind<V>) attribute.kind();
        var widget = new ArrowWidget(label, attribute.title(), NumberSetting.of(attribute.title(),
                new StepRange(quantity.step(), quantity.min(), quantity.max()), (v, gesture) -> set(settings -> {
                    quantity.check(attribute.title(), v);
                    return attribute.with(settings, quantity.with(attribute.get(settings), 0, v));
                }, gesture)));
        widget.setId("world-indirect-" + attribute.name());
        return widget;
    }

    private Optional<String> set(UnaryOperator<IndirectSettings> change, @Nullable Object gesture) {
        return edit(now -> now.map(change), gesture);
    }

    private Optional<String> edit(UnaryOperator<Optional<IndirectSettings>> change, @Nullable Object gesture) {
        return editor.edit(scene -> EditOutcome.of(() -> edited(scene, change)), gesture);
    }

    private static Scene edited(Scene scene, UnaryOperator<Optional<IndirectSettings>> change) {
        return scene.withPicture(scene.picture().withIndirect(change.apply(scene.picture().indirect())));
    }

    private void report(Optional<String> refusal) {
        refusal.ifPresent(editor.message()::show);
    }
}
