package lightning.editor.window.property;

import java.util.Optional;
import java.util.function.BiFunction;
import java.util.function.UnaryOperator;
import javafx.beans.value.ObservableValue;
import javafx.scene.layout.VBox;
import lightning.base.math.Rgb;
import lightning.base.text.Messages;
import lightning.editor.document.EditorState;
import lightning.editor.document.HsvColor;
import lightning.editor.document.LightGroupEdits;
import lightning.editor.document.StepRange;
import lightning.editor.window.model.SceneEditor;
import lightning.editor.window.widget.ArrowWidget;
import lightning.editor.window.widget.ColorSliders;
import lightning.editor.window.widget.NumberSetting;
import lightning.scene.attribute.NumericKind;
import lightning.scene.attribute.SceneAttribute;
import lightning.scene.light.Light;
import lightning.scene.light.LightGroup;
import org.jspecify.annotations.Nullable;

/** Section with the selected light's group, and the master and gel of that group. */
final class LightGroupSection extends VBox {
    private static final String NO_GROUP = Messages.key("the light is in no light group");

    private final SceneEditor editor;
    private final ArrowWidget master;
    private final ColorSliders gel;

    /**
     * @param groupBox  box that chooses the light's group
     * @param visibleState  state as in {@link PropertyPane}
     */
    LightGroupSection(SceneEditor editor, NameBox groupBox, ObservableValue<EditorState> visibleState) {
        this.editor = editor;
        getStyleClass().add("section-content");
        master = new ArrowWidget(Messages.tr("Master"), "master", setting("master", LightGroup.INTENSITY, (Double v, Double x) -> x));
        master.setId("master");
        gel = ColorSliders.forSurface("gel", Messages.tr("Multiplies the color of every light in the group"), 1, new GelTarget());
        gel.setId("gel");
        getChildren().addAll(groupBox, master, SectionLayout.caption(Messages.tr("Gel")), gel);
        visibleState.subscribe(this::show);
    }

    private void show(EditorState state) {
        Optional<LightGroup> group = state.selectedLight().flatMap(l -> state.scene().rig().lightGroup(l.lightGroup()));
        Optional<String> reason = group.isPresent() ? Optional.empty() : Optional.of(Messages.tr(NO_GROUP));
        master.setDisabledReason(reason);
        gel.setDisabledReason(reason);
        group.ifPresentOrElse(b -> master.show(b.intensity()), master::showNothing);
        group.ifPresentOrElse(b -> gel.show(b.color()), gel::showNothing);
    }

    /** Discards uncommitted input. */
    void revert() {
        master.revert();
        gel.revert();
    }

    private <V> NumberSetting setting(String title, SceneAttribute<LightGroup, V> attribute, BiFunction<V, Double, V> edit) {
        NumericKind<V> quantity = (NumericKind<V>) attribute.kind();
        return NumberSetting.of(title, new StepRange(quantity.step(), quantity.min(), quantity.max()),
                (value, gesture) -> edit(attribute, v -> edit.apply(v, value), gesture));
    }

    private <V> Optional<String> edit(SceneAttribute<LightGroup, V> attribute, UnaryOperator<V> change, @Nullable Object gesture) {
        Light light = editor.selection().light();
        String name = light == null ? "" : light.lightGroup();
        return editor.edit(scene -> LightGroupEdits.edit(scene, name, b -> attribute.with(b, change.apply(attribute.get(b)))), gesture);
    }

    /** Target of the gel's color edits. */
    private final class GelTarget implements ColorSliders.Target {
        @Override
        public NumberSetting red() {
            return setting("gel red", LightGroup.COLOR, (c, v) -> new Rgb(v, c.g(), c.b()));
        }

        @Override
        public NumberSetting green() {
            return setting("gel green", LightGroup.COLOR, (c, v) -> new Rgb(c.r(), v, c.b()));
        }

        @Override
        public NumberSetting blue() {
            return setting("gel blue", LightGroup.COLOR, (c, v) -> new Rgb(c.r(), c.g(), v));
        }

        @Override
        public Optional<String> hsv(HsvColor color, @Nullable Object gesture) {
            return edit(LightGroup.COLOR, _ -> color.rgb(), gesture);
        }
    }
}
