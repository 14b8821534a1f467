package lightning.editor.window.property;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import javafx.beans.value.ObservableValue;
import javafx.scene.Node;
import javafx.scene.control.CheckBox;
import javafx.scene.control.ComboBox;
import javafx.scene.control.ScrollPane;
import javafx.scene.control.Tooltip;
import javafx.scene.layout.Priority;
import javafx.scene.layout.VBox;
import lightning.base.text.Messages;
import lightning.base.text.NumberUnit;
import lightning.editor.document.Command;
import lightning.editor.document.EditOutcome;
import lightning.editor.document.EditorState;
import lightning.editor.document.NumericParameter;
import lightning.editor.window.command.CommandButton;
import lightning.editor.window.model.EditorModel;
import lightning.editor.window.model.SceneEditor;
import lightning.editor.window.model.ViewActions;
import lightning.editor.window.widget.ArrowWidget;
import lightning.editor.window.widget.ColorSliders;
import lightning.editor.window.widget.NumberSetting;
import lightning.render.image.DisplayCurve;
import lightning.scene.Dome;
import lightning.scene.World;
import org.jspecify.annotations.Nullable;

/** Properties of the scene as a whole: ambient light, background, environments, fog, indirect light and view. */
final class WorldPane extends VBox {
    private final SceneEditor editor;
    private final ViewActions views;
    /** Editor state, updated only while the pane is visible. */
    private final ObservableValue<EditorState> visibleState;
    private final List<ArrowWidget> numbers = new ArrayList<>();
    private final ColorSliders background;
    private final VBox backgroundRows;
    private final VBox environmentRows;
    private final ComboBox<DisplayCurve> curve = new ComboBox<>();
    private final FogControls fog;
    private final SkyControls sky;
    private final DomeControls domes;
    private final Node imageField;
    private final ArrowWidget exposure;
    private final CheckBox solo = new CheckBox(Messages.tr("Solo"));
    private @Nullable Object shownDocument;
    private boolean isUpdating;

    /** @param tabSelected  true while the pane is visible; it is updated only then */
    WorldPane(EditorModel model, ObservableValue<Boolean> tabSelected) {
        editor = model.editor();
        views = model.viewActions();
        visibleState = editor.editorStateProperty().when(tabSelected);
        setId("world");
        getStyleClass().add("properties");
        background = new WorldColor(editor, World.BACKGROUND, "world-background",
                Messages.tr("Color behind the scene, also seen in reflections")).sliders();
        fog = new FogControls(editor, visibleState);
        sky = new SkyControls(editor, visibleState);
        domes = new DomeControls(model, visibleState);
        imageField = FileField.forWorld(editor, model.commands(), model.fileImporter(), visibleState);
        solo.setId("world-solo");
        solo.setTooltip(new Tooltip(Messages.tr("Mute all lights that are not solo")));
        solo.setOnAction(_ -> {
            boolean isSolo = solo.isSelected();
            editor.editOrReport(scene -> EditOutcome.of(() -> scene.withWorld(World.SOLO.with(scene.world(), isSolo))));
        });
        backgroundRows = new VBox(SectionLayout.caption(Messages.tr("Background")), background);
        environmentRows = new VBox();
        NumericParameter.ENVIRONMENT.forEach(parameter -> environmentRows.getChildren().add(number(parameter)));
        environmentRows.getChildren().add(solo);
        Stream.of(backgroundRows, environmentRows).forEach(rows -> rows.getStyleClass().add("section-rows"));
        exposure = new ArrowWidget(Messages.tr("Exposure"), "exposure", exposureSetting());
        exposure.setId("world-exposure");
        ScrollPane scroll = SectionLayout.scroll(
                SectionLayout.section(Messages.tr("Environment"),
                        imageField, sky,
                        new EnvironmentPicture(editor, visibleState), environmentRows,
                        number(NumericParameter.AMBIENCE), backgroundRows, number(NumericParameter.METERS)),
                SectionLayout.section(Messages.tr("Domes"), domes),
                SectionLayout.section(Messages.tr("Fog"), fog),
                SectionLayout.section(Messages.tr("Indirect Light"), new IndirectControls(editor, model.commands(), visibleState)),
                SectionLayout.section(Messages.tr("View"), SectionLayout.caption(Messages.tr("View Transform")), curveBox(), exposure,
                        lut(model)));
        setVgrow(scroll, Priority.ALWAYS);
        getChildren().add(scroll);
        visibleState.subscribe(this::show);
        views.viewProperty().subscribe(view -> {
            isUpdating = true;
            curve.setValue(view.curve());
            isUpdating = false;
            exposure.show(view.exposure());
        });
    }

    private ArrowWidget number(NumericParameter parameter) {
        ArrowWidget widget = ParameterSetting.widget(editor, parameter, visibleState);
        numbers.add(widget);
        return widget;
    }

    private NumberSetting exposureSetting() {
        return NumberSetting.of("exposure", ViewActions.EXPOSURE_RANGE, NumberUnit.STOPS, views::setExposure);
    }

    private Node curveBox() {
        curve.setId("world-curve");
        curve.setAccessibleText(Messages.tr("View Transform"));
        curve.setMaxWidth(Double.MAX_VALUE);
        curve.getItems().setAll(DisplayCurve.values());
        curve.setConverter(new CurveTitles());
        curve.valueProperty().addListener((_, _, now) -> {
            if (!isUpdating && now != null) {
                views.setCurve(now);
            }
        });
        return curve;
    }

    private static Node lut(EditorModel model) {
        CommandButton lut = CommandButton.titledButton(model.commands(), Command.COLOR_TABLE);
        lut.button().setMaxWidth(Double.MAX_VALUE);
        return lut;
    }

    private void show(EditorState state) {
        if (editor.document() != shownDocument) {
            // Uncommitted input belongs to the other file.
            shownDocument = editor.document();
            numbers.forEach(ArrowWidget::revert);
            exposure.revert();
            background.revert();
            fog.revert();
            sky.revert();
            domes.revert();
        }
        boolean hasEnvironment = state.scene().world().environment().isPresent();
        setShown(environmentRows, hasEnvironment);
        setShown(backgroundRows, state.scene().world().environments().stream().noneMatch(Dome::on));
        background.show(state.scene().world().background());
        fog.show(state.scene().world().fog());
        sky.show(state.scene().world().sky());
        setShown(imageField, !state.scene().world().sky().on());
        solo.setSelected(state.scene().world().own().solo());
    }

    /** Shows a part only while it has an effect. */
    static void setShown(Node part, boolean shown) {
        part.setVisible(shown);
        part.setManaged(shown);
    }
}
