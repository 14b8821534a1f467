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
import lightning.base.text.Texts;
import lightning.editor.document.Command;
import lightning.editor.document.Dial;
import lightning.editor.document.LightEdits;
import lightning.editor.document.OpenDocument;
import lightning.editor.document.Situation;
import lightning.editor.window.command.CommandButton;
import lightning.editor.window.model.Commands;
import lightning.editor.window.model.FileBringer;
import lightning.editor.window.model.SceneEditor;
import lightning.editor.window.widget.ArrowWidget;
import lightning.editor.window.widget.ColorSliders;
import lightning.editor.window.widget.VectorField;
import lightning.scene.Choice;
import lightning.scene.Light;
import lightning.scene.LightAttribute;
import lightning.scene.LightAttribute.Section;
import lightning.scene.Quantity;
import lightning.scene.ValueKind;

/** The property editor of the selected light and the scene (paper §3.2, Figure 5). */
public final class PropertyPane extends VBox {
    private static final String NO_LIGHT = Texts.key("no light is selected");

    private final SceneEditor editor;
    private final Commands commands;
    private final FileBringer files;
    private final PropertyMenu menu;
    private final List<ArrowWidget> dials = new ArrayList<>();
    private final List<Row> rows = new ArrayList<>();
    private final LightHeader header;
    private final BankSection bank;
    /** How things are, told while the pane is in front. */
    private final ObservableValue<Situation> seen;
    private Shown shown;

    /**
     * The widget of an attribute that is no dial.
     *
     * @param obstacle disables it and says why; or enables it
     * @param revert   discards what was typed
     */
    private record Row(LightAttribute<?> attribute, Consumer<Optional<String>> obstacle, Consumer<Light> show, Runnable showNothing,
            Runnable revert) {}

    /** @param light its number in the document's history; −1 for none */
    private record Shown(OpenDocument document, long light) {}

    /**
     * @param menu    opens on each property
     * @param inFront whether the pane is seen: else only what was typed is heard to be of another light, and nothing is shown
     */
    PropertyPane(SceneEditor editor, Commands commands, FileBringer files, PropertyMenu menu, ObservableValue<Boolean> inFront) {
        this.editor = editor;
        this.commands = commands;
        this.files = files;
        this.menu = menu;
        seen = editor.situationProperty().when(inFront);
        setId("properties");
        getStyleClass().add("properties");
        header = new LightHeader(editor, commands);
        bank = new BankSection(editor, new NameBox(editor, LightAttribute.BANK, (ValueKind.Naming) LightAttribute.BANK.kind(), seen), seen);
        ScrollPane scroll = Sections.scroll(Stream.of(Stream.of(header),
                Stream.of(Section.COLOUR, Section.CONE, Section.AREA, Section.ATTENUATION, Section.PLACE, Section.LINKS)
                        .map(this::section),
                Stream.of(Sections.section(Texts.of("Bank"), bank),
                        Sections.section(Texts.of("Scene"), dial(Dial.AMBIENCE), Sections.caption(Texts.of("Environment")),
                                FilePart.ofWorld(editor, commands, files, seen),
                                dial(Dial.ENVIRONMENT_INTENSITY), dial(Dial.ENVIRONMENT_ROTATION),
                                dial(Dial.ENVIRONMENT_LAMPS), dial(Dial.ENVIRONMENT_SOFTNESS))))
                .flatMap(s -> s)
                .toArray(Node[]::new));
        setVgrow(scroll, Priority.ALWAYS);
        getChildren().add(scroll);
        editor.situationProperty().subscribe(this::revert);
        seen.subscribe(this::show);
    }

    private Node section(Section section) {
        List<Node> widgets = new ArrayList<>(LightAttribute.ALL.stream().filter(a -> a.section() == section)
                .flatMap(a -> widgets(a).stream()).toList());
        if (section == Section.PLACE) {
            widgets.add(aim());
        }
        return Sections.section(Sections.title(section.name()), widgets.toArray(Node[]::new));
    }

    /** What shows and edits an attribute, from the top. */
    <V> List<? extends Node> widgets(LightAttribute<V> attribute) {
        return switch (attribute.kind()) {
            case Quantity<V> q -> switch (q.form()) {
                case COLOR -> List.of(withMenu(color(attribute, q), attribute));
                case POSITION, DIRECTION ->
                        List.of(Sections.caption(Sections.title(attribute.title())), withMenu(vector(attribute, q), attribute));
                case EACH -> Dial.of(attribute).stream().map(d -> withMenu(dial(d), attribute)).toList();
            };
            case ValueKind.Filed<?> kind -> List.of(Sections.caption(Sections.title(attribute.title())),
                    withMenu(FilePart.of(editor, commands, files, of(attribute, kind), kind, seen), attribute));
            case Choice<V> c -> List.of(Sections.caption(Sections.title(attribute.title())), withMenu(choice(attribute, c), attribute));
            case ValueKind.Linking kind -> List.of(Sections.caption(Texts.of(kind.caption())),
                    withMenu(new LinksPart(editor, commands, of(attribute, kind), kind, seen), attribute));
            case ValueKind.Naming kind -> List.of(Sections.caption(Sections.title(attribute.title())),
                    withMenu(new NameBox(editor, of(attribute, kind), kind, seen), attribute));
        };
    }

    /** The attribute with the values of its kind: the compiler cannot follow that. */
    @SuppressWarnings("unchecked")
    private static <V> LightAttribute<V> of(LightAttribute<?> attribute, ValueKind.OfLight<V> kind) {
        return (LightAttribute<V>) attribute;
    }

    private <V> ColorSliders color(LightAttribute<V> attribute, Quantity<V> quantity) {
        var sliders = new ColorSliders(new LightColor(editor));
        sliders.setId(attribute.name());
        rows.add(new Row(attribute, sliders::setObstacle, light -> sliders.show(quantity.color(attribute.of(light))),
                sliders::showNothing, sliders::revert));
        return sliders;
    }

    private <V> Node choice(LightAttribute<V> attribute, Choice<V> choice) {
        var words = new WordBox<>(attribute, choice, "", v -> editor.editOrReport(
                scene -> LightEdits.with(scene, editor.selection().lightName(), light -> attribute.with(light, v))));
        rows.add(new Row(attribute, words::setObstacle, light -> words.show(attribute.of(light)), words::showNothing, () -> {}));
        return words;
    }

    private <N extends Node> N withMenu(N widget, LightAttribute<?> attribute) {
        menu.on(widget, new PropertyOwner.OfLight(editor.selection(), attribute));
        return widget;
    }

    private ArrowWidget dial(Dial dial) {
        ArrowWidget widget = DialGauge.widget(editor, dial, seen);
        dials.add(widget);
        return widget;
    }

    private <V> VectorField vector(LightAttribute<V> attribute, Quantity<V> quantity) {
        VectorField field = new VectorField(attribute.title(), (v, gesture) -> editor.edit(scene -> LightEdits.with(scene,
                editor.selection().lightName(), light -> attribute.with(light, quantity.join().apply(List.of(v.x(), v.y(), v.z())))),
                gesture));
        field.setId(attribute.title());
        rows.add(new Row(attribute, field::setObstacle, light -> field.show(quantity.vector(attribute.of(light))), field::showNothing,
                field::revert));
        return field;
    }

    private Node aim() {
        CommandButton aim = CommandButton.titled(commands, Command.AIM);
        aim.button().setMaxWidth(Double.MAX_VALUE);
        return aim;
    }

    /** What was typed was meant for the light selected then. */
    private void revert(Situation now) {
        var selected = new Shown(editor.document(), now.selected().map(l -> editor.document().history().id(l.name())).orElse(-1L));
        if (!selected.equals(shown)) {
            shown = selected;
            header.revert();
            bank.revert();
            rows.forEach(row -> row.revert().run());
            dials.forEach(ArrowWidget::revert);
        }
    }

    private void show(Situation now) {
        rows.forEach(row -> {
            row.obstacle().accept(obstacle(now, row.attribute()));
            now.selected().ifPresentOrElse(row.show(), row.showNothing());
        });
    }

    /** A directional light has a place too: its gizmo stands there. */
    private static Optional<String> obstacle(Situation now, LightAttribute<?> attribute) {
        return now.selected().isEmpty() ? Optional.of(Texts.of(NO_LIGHT))
                : attribute == LightAttribute.POSITION ? Optional.empty() : attribute.obstacle(now.selected().get().type());
    }
}
