package lightning.editor.window.property;

import java.util.List;
import javafx.beans.value.ObservableValue;
import javafx.scene.control.CheckBox;
import javafx.scene.control.Tooltip;
import javafx.scene.layout.VBox;
import lightning.base.text.Messages;
import lightning.editor.document.EditOutcome;
import lightning.editor.document.EditorState;
import lightning.editor.document.NumericParameter;
import lightning.editor.window.model.SceneEditor;
import lightning.editor.window.widget.ArrowWidget;
import lightning.editor.window.widget.ColorSliders;
import lightning.scene.SkyAttributes;
import lightning.scene.sky.Sky;
import lightning.scene.sky.SkyUnit;

/** Settings of the physical sky; all but its switch are shown only while it is on. */
final class SkyControls extends VBox {
    private final CheckBox on = new CheckBox(Messages.tr("Physical Sky"));
    private final CheckBox nits = new CheckBox(Messages.tr("Brightness in Nits"));
    private final List<ArrowWidget> numbers;
    private final ColorSliders ground;
    private final VBox rows;

    /** @param visibleState state as in {@link PropertyPane} */
    SkyControls(SceneEditor editor, ObservableValue<EditorState> visibleState) {
        on.setId("world-sky");
        on.setTooltip(new Tooltip(Messages.tr("Clear sky with a sun as the environment, instead of an image")));
        on.setOnAction(_ -> {
            boolean isOn = on.isSelected();
            editor.editOrReport(
                    scene -> EditOutcome.of(() -> scene.withWorld(scene.world().withSky(scene.world().sky().withOn(isOn)))));
        });
        nits.setId("world-sky-nits");
        nits.setTooltip(new Tooltip(Messages.tr("For lights with photometric units; otherwise a value of 1 is 10 000 nits")));
        nits.setOnAction(_ -> {
            SkyUnit unit = nits.isSelected() ? SkyUnit.NIT : SkyUnit.RELATIVE;
            editor.editOrReport(
                    scene -> EditOutcome.of(() -> scene.withWorld(scene.world().withSky(scene.world().sky().withUnit(unit)))));
        });
        numbers = NumericParameter.SKY.stream().map(parameter -> ParameterSetting.widget(editor, parameter, visibleState)).toList();
        ground = new WorldColor(editor, SkyAttributes.GROUND, "world-sky-ground",
                Messages.tr("Share of the light that the ground reflects"))
                .sliders();
        rows = new VBox();
        rows.getChildren().addAll(numbers);
        rows.getChildren().add(new SunPlacePane(editor));
        rows.getChildren().addAll(SectionLayout.caption(Messages.tr("Ground Color")), ground, nits);
        List.of(this, rows).forEach(part -> part.getStyleClass().add("section-rows"));
        getChildren().addAll(on, rows);
    }

    /** Discards uncommitted input. */
    void revert() {
        numbers.forEach(ArrowWidget::revert);
        ground.revert();
    }

    void show(Sky sky) {
        WorldPane.setShown(rows, sky.on());
        on.setSelected(sky.on());
        nits.setSelected(sky.unit() == SkyUnit.NIT);
        ground.show(sky.ground());
    }
}
