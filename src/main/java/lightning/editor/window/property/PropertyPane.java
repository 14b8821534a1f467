package lightning.editor.window.property;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.stream.Stream;
import javafx.beans.value.ObservableValue;
import javafx.scene.Node;
import javafx.scene.control.ScrollPane;
import javafx.scene.layout.Priority;
import javafx.scene.layout.VBox;
import lightning.base.text.Messages;
import lightning.editor.document.Command;
import lightning.editor.document.EditorState;
import lightning.editor.document.LightEdits;
import lightning.editor.document.NumericParameter;
import lightning.editor.document.OpenDocument;
import lightning.editor.window.command.CommandButton;
import lightning.editor.window.model.CommandRegistry;
import lightning.editor.window.model.FileImporter;
import lightning.editor.window.model.SceneEditor;
import lightning.editor.window.widget.ArrowWidget;
import lightning.editor.window.widget.ColorSliders;
import lightning.editor.window.widget.TemperatureSlider;
import lightning.editor.window.widget.VectorField;
import lightning.scene.SceneElement;
import lightning.scene.attribute.ChoiceKind;
import lightning.scene.attribute.NumericKind;
import lightning.scene.attribute.ValueKind;
import lightning.scene.light.IntensityUnit;
import lightning.scene.light.Light;
import lightning.scene.light.LightAttribute;
import lightning.scene.light.LightAttribute.Section;
import lightning.scene.light.LightType;
import org.jspecify.annotations.Nullable;

/** Property editor of the selected light (paper §3.2, Figure 5). */
public final class PropertyPane extends VBox {
    private static final String NO_LIGHT = Messages.key("no light is selected");

    private final SceneEditor editor;
    private final CommandRegistry commands;
    private final FileImporter files;
    private final PropertyMenu menu;
    private final List<ArrowWidget> parameterWidgets = new ArrayList<>();
    private final List<Row> rows = new ArrayList<>();
    private final List<Hideable> hideable = new ArrayList<>();
    private final LightHeader header;
    private final LightGroupSection groupSection;
    /** Editor state, updated only while the pane is visible. */
    private final ObservableValue<EditorState> visibleState;
    private @Nullable ShownLight shownLight;

    /**
     * Widget of an attribute without numeric parameters.
     *
     * @param setDisabledReason  disables it with a reason, or enables it
     * @param revert  discards uncommitted input
     */
    private record Row(LightAttribute<?> attribute, Consumer<Optional<String>> setDisabledReason, Consumer<Light> show,
            Runnable showNothing,
            Runnable revert) {}

    /** @param lightId  light's id in the document's history; −1 for none */
    private record ShownLight(OpenDocument document, long lightId) {}

    /** Nodes that are shown only if any of the attributes acts on the light. */
    private record Hideable(List<LightAttribute<?>> attributes, List<Node> nodes) {
        void show(Light light) {
            boolean acts = attributes.stream().anyMatch(a -> actsOn(light, a));
            nodes.forEach(node -> {
                node.setVisible(acts);
                node.setManaged(acts);
            });
        }

        /** A directional light keeps its position, where its gizmo is drawn; that of an object has none. */
        private static boolean actsOn(Light light, LightAttribute<?> attribute) {
            return attribute == LightAttribute.POSITION && light.type() != LightType.OBJECT
                    || attribute.inactiveReason(light).isEmpty()
                            && (attribute != LightAttribute.SAMPLES && attribute != LightAttribute.VISIBLE || light.hasSamples());
        }
    }

    /**
     * @param menu  context menu of the properties
     * @param tabSelected  true while the pane is visible; a hidden pane only discards uncommitted input of another light
     */
    PropertyPane(SceneEditor editor, CommandRegistry commands, FileImporter files, PropertyMenu menu,
            ObservableValue<Boolean> tabSelected) {
        this.editor = editor;
        this.commands = commands;
        this.files = files;
        this.menu = menu;
        visibleState = editor.editorStateProperty().when(tabSelected);
        setId("properties");
        getStyleClass().add("properties");
        header = new LightHeader(editor, commands);
        groupSection = new LightGroupSection(editor,
                new NameBox(editor, LightAttribute.LIGHT_GROUP, (ValueKind.NameKind) LightAttribute.LIGHT_GROUP.kind(), visibleState),
                visibleState);
        ScrollPane scroll = SectionLayout.scroll(Stream.of(Stream.of(header),
                Stream.of(Section.COLOR, Section.CONE, Section.AREA, Section.ATTENUATION, Section.PLACE, Section.FILTERS,
                        Section.CONTRIBUTION,
                        Section.LINKS)
                        .map(this::section),
                Stream.of(SectionLayout.section(Messages.tr("Light Group"), groupSection)))
                .flatMap(s -> s)
                .toArray(Node[]::new));
        setVgrow(scroll, Priority.ALWAYS);
        getChildren().add(scroll);
        editor.editorStateProperty().subscribe(this::revert);
        visibleState.subscribe(this::show);
    }

    private Node section(Section section) {
        List<LightAttribute<?>> attributes = LightAttribute.ALL.stream().filter(a -> a.section() == section).toList();
        List<Node> widgets = new ArrayList<>();
        for (LightAttribute<?> attribute : attributes) {
            List<? extends Node> own = widgets(attribute);
            widgets.addAll(own);
            hideable.add(new Hideable(List.of(attribute), List.copyOf(own)));
        }
        if (section == Section.PLACE) {
            widgets.add(aim());
        }
        Node pane = SectionLayout.section(SectionLayout.title(section.title()), widgets.toArray(Node[]::new));
        hideable.add(new Hideable(attributes, List.of(pane)));
        return pane;
    }

    /** Returns the widgets of an attribute, from top to bottom. */
    <V> List<? extends Node> widgets(LightAttribute<V> attribute) {
        return switch (attribute.kind()) {
            case NumericKind<V> q -> switch (q.form()) {
                case COLOR -> List.of(withMenu(color(attribute, q), attribute));
                case POSITION, DIRECTION ->
                        List.of(SectionLayout.caption(SectionLayout.title(attribute.title())), withMenu(vector(attribute, q), attribute));
                case INDEPENDENT -> attribute == LightAttribute.TEMPERATURE ? temperature()
                        : NumericParameter.of(attribute).stream().map(d -> withMenu(parameterWidget(d), attribute)).toList();
            };
            case ValueKind.AssetKind<?> kind -> List.of(SectionLayout.caption(SectionLayout.title(attribute.title())),
                    withMenu(FileField.forLight(editor, commands, files, castAttribute(attribute, kind), kind, visibleState), attribute));
            case ChoiceKind<V> c ->
                    List.of(SectionLayout.caption(SectionLayout.title(attribute.title())), withMenu(choice(attribute, c), attribute));
            case ValueKind.LinksKind kind -> List.of(SectionLayout.caption(Messages.tr(kind.caption())),
                    withMenu(new LinksField(editor, commands, castAttribute(attribute, kind), kind, visibleState), attribute));
            case ValueKind.GainsKind kind -> List.of(SectionLayout.caption(SectionLayout.title(attribute.title())),
                    withMenu(new GainsField(commands, castAttribute(attribute, kind), kind, visibleState), attribute));
            case ValueKind.NameKind kind -> List.of(SectionLayout.caption(SectionLayout.title(attribute.title())),
                    withMenu(new NameBox(editor, castAttribute(attribute, kind), kind, visibleState), attribute));
        };
    }

    /** Casts an attribute to the value type of its kind, which the compiler cannot infer. */
    @SuppressWarnings("unchecked")
    private static <V> LightAttribute<V> castAttribute(LightAttribute<?> attribute, ValueKind.LightKind<V> kind) {
        return (LightAttribute<V>) attribute;
    }

    private <V> ColorSliders color(LightAttribute<V> attribute, NumericKind<V> quantity) {
        var sliders = new ColorSliders(new LightColor(editor));
        sliders.setId(attribute.name());
        rows.add(new Row(attribute, sliders::setDisabledReason, light -> sliders.show(quantity.color(attribute.get(light))),
                sliders::showNothing, sliders::revert));
        return sliders;
    }

    private <V> Node choice(LightAttribute<V> attribute, ChoiceKind<V> choice) {
        var box = new AttributeChoiceBox<>(attribute, choice, "", v -> editor.editOrReport(
                scene -> LightEdits.setChoice(scene, editor.selection().lightName(), attribute, v)));
        rows.add(new Row(attribute, box::setDisabledReason, light -> box.show(attribute.get(light), v -> isUsual(v, light)),
                box::showNothing, () -> {}));
        return box;
    }

    private static boolean isUsual(Object choice, Light light) {
        return !(choice instanceof IntensityUnit unit) || unit.isUsualFor(light);
    }

    private List<Node> temperature() {
        var slider = new TemperatureSlider((kelvin, gesture) -> editor
                .edit(scene -> LightEdits.setTemperature(scene, editor.selection().lightName(), kelvin), gesture));
        slider.setId(LightAttribute.TEMPERATURE.id());
        rows.add(new Row(LightAttribute.TEMPERATURE, slider::setDisabledReason, light -> slider.show(light.emission().temperature()),
                slider::showNothing, slider::revert));
        return List.of(SectionLayout.caption(SectionLayout.title(LightAttribute.TEMPERATURE.title())),
                withMenu(slider, LightAttribute.TEMPERATURE));
    }

    private <N extends Node> N withMenu(N widget, LightAttribute<?> attribute) {
        menu.attach(widget, new SelectedProperty<>(
                () -> Optional.ofNullable(editor.selection().light()).map(l -> new SceneElement.OfLight(l.name())), attribute));
        return widget;
    }

    private ArrowWidget parameterWidget(NumericParameter parameter) {
        ArrowWidget widget = ParameterSetting.widget(editor, parameter, visibleState);
        parameterWidgets.add(widget);
        return widget;
    }

    private <V> VectorField vector(LightAttribute<V> attribute, NumericKind<V> quantity) {
        VectorField field = new VectorField(attribute.title(), (v, gesture) -> editor.edit(scene -> LightEdits.edit(scene,
                editor.selection().lightName(), light -> attribute.with(light, quantity.compose().apply(List.of(v.x(), v.y(), v.z())))),
                gesture));
        field.setId(attribute.id());
        rows.add(
                new Row(attribute, field::setDisabledReason, light -> field.show(quantity.vector(attribute.get(light))), field::showNothing,
                        field::revert));
        return field;
    }

    private Node aim() {
        CommandButton aim = CommandButton.titledButton(commands, Command.AIM);
        aim.button().setMaxWidth(Double.MAX_VALUE);
        return aim;
    }

    /** Discards uncommitted input when another light is selected. */
    private void revert(EditorState state) {
        var selected =
                new ShownLight(editor.document(), state.selectedLight().map(l -> editor.document().history().id(l.name())).orElse(-1L));
        if (!selected.equals(shownLight)) {
            shownLight = selected;
            header.revert();
            groupSection.revert();
            rows.forEach(row -> row.revert().run());
            parameterWidgets.forEach(ArrowWidget::revert);
        }
    }

    private void show(EditorState state) {
        state.selectedLight().ifPresent(light -> hideable.forEach(part -> part.show(light)));
        rows.forEach(row -> {
            row.setDisabledReason().accept(disabledReason(state, row.attribute()));
            state.selectedLight().ifPresentOrElse(row.show(), row.showNothing());
        });
    }

    /** Returns why an attribute is disabled. A directional light keeps its position, where its gizmo is drawn. */
    private static Optional<String> disabledReason(EditorState state, LightAttribute<?> attribute) {
        return state.selectedLight().isEmpty() ? Optional.of(Messages.tr(NO_LIGHT))
                : attribute == LightAttribute.POSITION ? Optional.empty() : attribute.inactiveReason(state.selectedLight().get());
    }
}
