package lightning.editor.window.property;

import java.util.ArrayList;
import java.util.List;
import javafx.beans.value.ObservableValue;
import javafx.scene.control.CheckBox;
import javafx.scene.control.Tooltip;
import javafx.scene.layout.VBox;
import lightning.base.math.Vec3;
import lightning.base.text.Messages;
import lightning.editor.document.EditOutcome;
import lightning.editor.document.EditorState;
import lightning.editor.document.NumericParameter;
import lightning.editor.window.model.SceneEditor;
import lightning.editor.window.widget.ArrowWidget;
import lightning.editor.window.widget.ColorSliders;
import lightning.scene.FogAttributes;
import lightning.scene.value.Fog;

/** Settings of the scene's fog; all but its density are shown only while there is any. */
final class FogControls extends VBox {
    /** Lengths of a new box, scene units. */
    private static final Vec3 NEW_BOX = new Vec3(10, 10, 10);

    private final SceneEditor editor;
    private final ObservableValue<EditorState> visibleState;
    private final List<ArrowWidget> numbers = new ArrayList<>();
    private final ColorSliders color;
    private final ColorSliders ambient;
    private final CheckBox box = new CheckBox(Messages.tr("Only in a Box"));
    private final VBox boxRows;
    private final VBox rows;

    /** @param visibleState state as in {@link PropertyPane} */
    FogControls(SceneEditor editor, ObservableValue<EditorState> visibleState) {
        this.editor = editor;
        this.visibleState = visibleState;
        color = new WorldColor(editor, FogAttributes.COLOR, "world-fog-color", Messages.tr("Share of the light that the fog scatters"))
                .sliders();
        ambient = new WorldColor(editor, FogAttributes.AMBIENT, "world-fog-ambient", Messages.tr("Light that comes from all sides"))
                .sliders();
        box.setId("world-fog-box");
        box.setTooltip(new Tooltip(Messages.tr("Fog in a box instead of everywhere")));
        box.setOnAction(_ -> {
            boolean hasBox = box.isSelected();
            editor.editOrReport(scene -> EditOutcome.of(() -> scene.withWorld(
                    scene.world().withFog(scene.world().fog().withSize(hasBox ? NEW_BOX : Vec3.ZERO)))));
        });
        boxRows = rows(NumericParameter.FOG_CENTER);
        boxRows.getChildren().addAll(rows(NumericParameter.FOG_SIZE).getChildren());
        rows = new VBox(SectionLayout.caption(Messages.tr("Fog Color")), color);
        rows.getChildren().addAll(rows(NumericParameter.FOG).getChildren());
        rows.getChildren().addAll(SectionLayout.caption(Messages.tr("Fog Ambient Light")), ambient, box, boxRows);
        List.of(this, rows, boxRows).forEach(part -> part.getStyleClass().add("section-rows"));
        getChildren().addAll(number(NumericParameter.FOG_DENSITY), rows);
    }

    private VBox rows(List<NumericParameter> parameters) {
        return new VBox(parameters.stream().map(this::number).toArray(ArrowWidget[]::new));
    }

    private ArrowWidget number(NumericParameter parameter) {
        ArrowWidget widget = ParameterSetting.widget(editor, parameter, visibleState);
        numbers.add(widget);
        return widget;
    }

    /** Discards uncommitted input. */
    void revert() {
        numbers.forEach(ArrowWidget::revert);
        color.revert();
        ambient.revert();
    }

    void show(Fog fog) {
        WorldPane.setShown(rows, fog.isPresent());
        WorldPane.setShown(boxRows, fog.hasBox());
        box.setSelected(fog.hasBox());
        color.show(fog.color());
        ambient.show(fog.ambient());
    }
}
