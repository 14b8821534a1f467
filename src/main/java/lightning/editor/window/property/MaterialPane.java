package lightning.editor.window.property;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import javafx.geometry.Pos;
import javafx.scene.Node;
import javafx.scene.control.ComboBox;
import javafx.scene.control.Label;
import javafx.scene.control.ScrollPane;
import javafx.scene.control.TitledPane;
import javafx.scene.layout.HBox;
import javafx.scene.layout.Priority;
import javafx.scene.layout.Region;
import javafx.scene.layout.StackPane;
import javafx.scene.layout.VBox;
import lightning.base.text.Texts;
import lightning.editor.document.Command;
import lightning.editor.document.MaterialEdits;
import lightning.editor.document.Steps;
import lightning.editor.window.command.CommandButton;
import lightning.editor.window.model.Commands;
import lightning.editor.window.model.FileBringer;
import lightning.editor.window.model.MaterialChoice;
import lightning.editor.window.model.SceneEditor;
import lightning.editor.window.widget.ArrowWidget;
import lightning.editor.window.widget.ColorSliders;
import lightning.editor.window.widget.Gauge;
import lightning.editor.window.widget.Obstacle;
import lightning.editor.window.widget.VectorField;
import lightning.scene.Choice;
import lightning.scene.Material;
import lightning.scene.MaterialAttribute;
import lightning.scene.MaterialAttribute.Section;
import lightning.scene.Quantity;
import lightning.scene.Scene;
import lightning.scene.TextureMap;
import lightning.scene.ValueKind;

/** The property editor of a material: its colours, its shininess, its texture. All shapes that have it change together. */
final class MaterialPane extends VBox {
    private static final String NO_MATERIAL = Texts.key("the scene has no shapes");
    private static final int NAMES_SHOWN = 4;
    /** Of shapes; takes some tens of microseconds. */
    private static final int WALKED_AT_ONCE = 1000;

    private final SceneEditor editor;
    private final MaterialChoice materials;
    private final Commands commands;
    private final FileBringer files;
    private final PropertyMenu menu;
    private final ComboBox<String> name = new ComboBox<>();
    private final Label users = new Label();
    private final List<Row> rows = new ArrayList<>();
    private final List<Part> parts = new ArrayList<>();
    private final Obstacle unnamed;
    private String shown = "";
    /** Of which material, among which nodes, {@link #users} tells. */
    private String toldUsersOf = "";
    private List<lightning.scene.Node> toldAmong = List.of();
    private boolean walking;
    private boolean showing;

    /**
     * The widget of an attribute, or of one of its numbers.
     *
     * @param obstacle disables it and says why; or enables it
     * @param revert   forgets what was typed
     */
    private record Row(MaterialAttribute<?> attribute, Node node, Consumer<Optional<String>> obstacle, Consumer<Material> show,
            Runnable showNothing, Runnable revert) {}

    /** Widgets that people find together. */
    private record Part(TitledPane pane, List<Row> rows) {
        /** Shows the attributes that a material has; all where there is none. */
        void fit(Material material) {
            boolean any = false;
            for (Row row : rows) {
                boolean acts = material == null || row.attribute().acts(material.model());
                any |= acts;
                row.node().setVisible(acts);
                row.node().setManaged(acts);
            }
            pane.setVisible(any);
            pane.setManaged(any);
        }
    }

    /** @param menu opens on each property */
    MaterialPane(SceneEditor editor, MaterialChoice materials, Commands commands, FileBringer files, PropertyMenu menu) {
        this.editor = editor;
        this.materials = materials;
        this.commands = commands;
        this.files = files;
        this.menu = menu;
        setId("material");
        getStyleClass().add("properties");
        name.setId("material-name");
        name.setAccessibleText(Texts.of("material"));
        name.setMaxWidth(Double.MAX_VALUE);
        var named = new StackPane(name);
        unnamed = new Obstacle(named, name, Texts.of("The material that is edited, with all shapes that have it"));
        HBox.setHgrow(named, Priority.ALWAYS);
        var row = new HBox(named, CommandButton.icon(commands, Command.PICK_MATERIAL));
        row.getStyleClass().add("header-row");
        users.setId("material-users");
        users.getStyleClass().add("caption");
        users.setWrapText(true);
        var header = new VBox(row, users);
        header.getStyleClass().add("light-header");
        ScrollPane scroll = Sections.gradual(box -> Stream.concat(Stream.of(() -> Sections.add(box, header)),
                Arrays.stream(Section.values()).flatMap(section -> parts(box, section))));
        setVgrow(scroll, Priority.ALWAYS);
        getChildren().add(scroll);
        name.valueProperty().addListener((_, _, now) -> {
            if (!showing && now != null) {
                materials.choose(now);
            }
        });
        materials.materialProperty().subscribe(this::show);
        editor.sceneProperty().subscribe((before, now) -> {
            if (!MaterialChoice.haveSameMaterials(before, now)) {
                show(materials.material());
            }
        });
    }

    /** Makes a section, and then its widgets one by one. */
    private Stream<Runnable> parts(VBox box, Section section) {
        var part = new Part(Sections.section(Sections.title(section.name())), new ArrayList<>());
        return Stream.concat(Stream.of(() -> {
            parts.add(part);
            part.fit(materials.material());
            Sections.add(box, part.pane());
        }), MaterialAttribute.ALL.stream().filter(a -> a.section() == section).map(a -> () -> rows(a).forEach(row -> add(part, row))));
    }

    private void add(Part part, Row row) {
        rows.add(row);
        part.rows().add(row);
        menu.on(row.node(), new PropertyOwner.OfMaterial(materials, row.attribute()));
        Material material = materials.material();
        row.obstacle().accept(obstacle(material));
        part.fit(material);
        if (material == null) {
            row.showNothing().run();
        } else {
            row.show().accept(material);
        }
        Sections.add((VBox) part.pane().getContent(), row.node());
    }

    private static Optional<String> obstacle(Material material) {
        return material == null ? Optional.of(Texts.of(NO_MATERIAL)) : Optional.empty();
    }

    private <V> List<Row> rows(MaterialAttribute<V> attribute) {
        return switch (attribute.kind()) {
            case Quantity<V> q -> switch (q.form()) {
                case COLOR -> List.of(color(attribute, q));
                case EACH -> IntStream.range(0, q.labels().size()).mapToObj(i -> number(attribute, q, i)).toList();
                case POSITION, DIRECTION -> List.of(vector(attribute, q));
            };
            case ValueKind.Texturing _ -> List.of(picture(pictured(attribute)));
            case Choice<V> c -> List.of(choice(attribute, c));
        };
    }

    private <V> Row color(MaterialAttribute<V> attribute, Quantity<V> q) {
        ColorSliders sliders = new SurfaceColor<>(editor, materials, attribute, q).sliders();
        return new Row(attribute, sliders, sliders::setObstacle, m -> sliders.show(q.color(attribute.of(m))), sliders::showNothing,
                sliders::revert);
    }

    private <V> Row number(MaterialAttribute<V> attribute, Quantity<V> q, int index) {
        String label = q.labels().get(index);
        String title = label.isEmpty() ? attribute.title() : attribute.title() + " " + label;
        ArrowWidget widget = new ArrowWidget(Sections.title(label.isEmpty() ? title : label), title,
                Gauge.of(title, new Steps(q.step(), q.min(), q.max()), q.measure(),
                        (v, gesture) -> editor.edit(scene -> MaterialEdits.with(scene, shown,
                                m -> attribute.with(m, q.with(attribute.of(m), index, v))), gesture)));
        widget.setId(title);
        return new Row(attribute, widget, widget::setObstacle, m -> widget.show(q.number(attribute.of(m), index)), widget::showNothing,
                widget::revert);
    }

    private <V> Row vector(MaterialAttribute<V> attribute, Quantity<V> q) {
        var field = new VectorField(attribute.title(), (v, gesture) -> editor.edit(scene -> MaterialEdits.with(scene, shown,
                m -> attribute.with(m, q.join().apply(List.of(v.x(), v.y(), v.z())))), gesture));
        field.setId(attribute.title());
        return new Row(attribute, field, field::setObstacle, m -> field.show(q.vector(attribute.of(m))), field::showNothing, field::revert);
    }

    private <V> Row choice(MaterialAttribute<V> attribute, Choice<V> choice) {
        var words = new WordBox<>(attribute, choice, Texts.of(attribute.help()),
                v -> editor.edit(scene -> MaterialEdits.set(scene, shown, attribute, v), null));
        Node node = attribute.section() == Section.MODEL ? words : named(Sections.title(attribute.title()), words);
        return new Row(attribute, node, words::setObstacle, m -> words.show(attribute.of(m)), words::showNothing, () -> {});
    }

    /** A box with its name at the left: a section of one box has the name in its head. */
    private static Node named(String title, WordBox<?> words) {
        var label = new Label(title);
        label.setLabelFor(words.box());
        var space = new Region();
        HBox.setHgrow(space, Priority.ALWAYS);
        var row = new HBox(label, space, words);
        row.setAlignment(Pos.CENTER_LEFT);
        return row;
    }

    /** Its kind has told that it is a picture: the compiler cannot follow that. */
    @SuppressWarnings("unchecked")
    private static MaterialAttribute<Optional<TextureMap>> pictured(MaterialAttribute<?> attribute) {
        return (MaterialAttribute<Optional<TextureMap>>) attribute;
    }

    private Row picture(MaterialAttribute<Optional<TextureMap>> attribute) {
        var part = new TexturePart(editor, commands, files, attribute);
        // It knows itself whether it shows another material.
        return new Row(attribute, part, part::setObstacle, part::show, part::showNothing, () -> {});
    }

    private void show(Material material) {
        Optional<String> obstacle = obstacle(material);
        rows.forEach(row -> row.obstacle().accept(obstacle));
        unnamed.set(obstacle);
        if (material == null) {
            showNothing();
            return;
        }
        if (!material.name().equals(shown)) {
            // What was typed was meant for the other material.
            rows.forEach(row -> row.revert().run());
        }
        shown = material.name();
        parts.forEach(part -> part.fit(material));
        showNames();
        rows.forEach(row -> row.show().accept(material));
    }

    private void showNothing() {
        shown = "";
        toldUsersOf = "";
        users.setText("");
        showing = true;
        name.setValue(null);
        showing = false;
        rows.forEach(row -> row.showNothing().run());
    }

    private void showNames() {
        showing = true;
        List<String> names = MaterialChoice.names(editor.scene());
        if (!name.getItems().equals(names)) {
            name.getItems().setAll(names);
        }
        name.setValue(shown);
        showing = false;
        if (!shown.equals(toldUsersOf) || editor.scene().nodes() != toldAmong) {
            tellUsers();
        }
    }

    /** All shapes are walked, so not for edits of the material itself; many of them not on the window's thread. */
    private void tellUsers() {
        toldUsersOf = shown;
        toldAmong = editor.scene().nodes();
        Scene scene = editor.scene();
        if (scene.stage().shapeCount() <= WALKED_AT_ONCE) {
            tell(MaterialChoice.shapesOf(scene, shown));
        } else if (!walking) {
            walking = true;
            String of = shown;
            files.files().beside(() -> MaterialChoice.shapesOf(scene, of), shapes -> {
                walking = false;
                if (of.equals(toldUsersOf) && scene.nodes() == toldAmong) {
                    tell(shapes);
                } else if (!toldUsersOf.isEmpty()) {
                    tellUsers();
                }
            }, _ -> walking = false);
        }
    }

    private void tell(List<String> shapes) {
        users.setText(
                shapes.isEmpty() ? Texts.of("No shape has it")
                        : Texts.of("On {0}", String.join(", ", shapes.subList(0, Math.min(NAMES_SHOWN, shapes.size()))))
                                + (shapes.size() > NAMES_SHOWN ? Texts.of(" and {0} more", shapes.size() - NAMES_SHOWN) : ""));
    }
}
