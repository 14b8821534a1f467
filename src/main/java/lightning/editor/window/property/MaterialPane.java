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
import lightning.base.text.Messages;
import lightning.editor.document.Command;
import lightning.editor.document.MaterialEdits;
import lightning.editor.document.StepRange;
import lightning.editor.window.command.CommandButton;
import lightning.editor.window.model.CommandRegistry;
import lightning.editor.window.model.FileImporter;
import lightning.editor.window.model.MaterialSelection;
import lightning.editor.window.model.SceneEditor;
import lightning.editor.window.widget.ArrowWidget;
import lightning.editor.window.widget.ColorSliders;
import lightning.editor.window.widget.DisabledReason;
import lightning.editor.window.widget.NumberSetting;
import lightning.editor.window.widget.VectorField;
import lightning.scene.Scene;
import lightning.scene.SceneElement;
import lightning.scene.asset.TextureMap;
import lightning.scene.attribute.ChoiceKind;
import lightning.scene.attribute.NumericKind;
import lightning.scene.attribute.ValueKind;
import lightning.scene.material.Material;
import lightning.scene.material.MaterialAttribute;
import lightning.scene.material.MaterialAttribute.Section;
import org.jspecify.annotations.Nullable;

/** Property editor of a material. Edits affect every shape that uses it. */
final class MaterialPane extends VBox {
    private static final String NO_MATERIAL = Messages.key("the scene has no objects");
    private static final int MAX_NAMES = 4;
    /** Maximum number of shapes to scan on the window's thread, which takes tens of microseconds. */
    private static final int MAX_INLINE_SHAPES = 1000;

    private final SceneEditor editor;
    private final MaterialSelection materials;
    private final CommandRegistry commands;
    private final FileImporter files;
    private final PropertyMenu menu;
    private final ComboBox<String> name = new ComboBox<>();
    private final Label users = new Label();
    private final List<Row> rows = new ArrayList<>();
    private final List<PropertySection> sections = new ArrayList<>();
    private final DisabledReason nameReason;
    private String shownName = "";
    /** Material and nodes that {@link #users} describes. */
    private String usersMaterial = "";
    private List<lightning.scene.node.SceneNode> usersNodes = List.of();
    private boolean isCounting;
    private boolean isUpdating;

    /**
     * Widget of an attribute or of one of its components.
     *
     * @param setDisabledReason  disables it with a reason, or enables it
     * @param revert  discards uncommitted input
     */
    private record Row(MaterialAttribute<?> attribute, Node node, Consumer<Optional<String>> setDisabledReason, Consumer<Material> show,
            Runnable showNothing, Runnable revert) {}

    /** Titled section of widgets. */
    private record PropertySection(TitledPane pane, List<Row> rows) {
        /** Shows the attributes that apply to a material and do something; all for null. */
        void showApplicable(@Nullable Material material) {
            boolean hasVisible = false;
            for (Row row : rows) {
                boolean applies = material == null
                        || row.attribute().appliesTo(material.model()) && !row.attribute().isPartOfNothing(material);
                hasVisible |= applies;
                row.node().setVisible(applies);
                row.node().setManaged(applies);
            }
            pane.setVisible(hasVisible);
            pane.setManaged(hasVisible);
        }
    }

    /** @param menu  context menu of the properties */
    MaterialPane(SceneEditor editor, MaterialSelection materials, CommandRegistry commands, FileImporter files, PropertyMenu menu) {
        this.editor = editor;
        this.materials = materials;
        this.commands = commands;
        this.files = files;
        this.menu = menu;
        setId("material");
        getStyleClass().add("properties");
        name.setId("material-name");
        name.setAccessibleText(Messages.tr("material"));
        name.setMaxWidth(Double.MAX_VALUE);
        var nameBox = new StackPane(name);
        nameReason = new DisabledReason(nameBox, name, Messages.tr("Material to edit; affects every object that uses it"));
        HBox.setHgrow(nameBox, Priority.ALWAYS);
        var row = new HBox(nameBox, CommandButton.iconButton(commands, Command.PICK_MATERIAL));
        row.getStyleClass().add("header-row");
        users.setId("material-users");
        users.getStyleClass().add("caption");
        users.setWrapText(true);
        var header = new VBox(row, users);
        header.getStyleClass().add("light-header");
        var library = new MaterialLibraryPane(editor, materials, files.files().windowExecutor());
        ScrollPane scroll = SectionLayout.incrementalScroll(box -> Stream.concat(Stream.of(() -> SectionLayout.add(box, header),
                () -> SectionLayout.add(box, library.section())),
                Arrays.stream(Section.values()).flatMap(section -> sectionSteps(box, section))));
        setVgrow(scroll, Priority.ALWAYS);
        getChildren().add(scroll);
        name.valueProperty().addListener((_, _, now) -> {
            if (!isUpdating && now != null) {
                materials.choose(now);
            }
        });
        materials.materialProperty().subscribe(this::show);
        editor.sceneProperty().subscribe((before, now) -> {
            if (!MaterialSelection.haveSameMaterials(before, now)) {
                show(materials.material());
            }
        });
    }

    /** Returns steps that create a section and then its widgets one by one. */
    private Stream<Runnable> sectionSteps(VBox box, Section section) {
        var propertySection = new PropertySection(SectionLayout.section(SectionLayout.title(section.title())), new ArrayList<>());
        return Stream.concat(Stream.of(() -> {
            sections.add(propertySection);
            propertySection.showApplicable(materials.material());
            SectionLayout.add(box, propertySection.pane());
        }), MaterialAttribute.ALL.stream().filter(a -> a.section() == section)
                .map(a -> () -> rows(a).forEach(row -> add(propertySection, row))));
    }

    private void add(PropertySection propertySection, Row row) {
        rows.add(row);
        propertySection.rows().add(row);
        menu.attach(row.node(), new SelectedProperty<>(
                () -> Optional.ofNullable(materials.material()).map(m -> new SceneElement.OfMaterial(m.name())), row.attribute()));
        Material material = materials.material();
        row.setDisabledReason().accept(disabledReason(material));
        propertySection.showApplicable(material);
        if (material == null) {
            row.showNothing().run();
        } else {
            row.show().accept(material);
        }
        SectionLayout.add((VBox) propertySection.pane().getContent(), row.node());
    }

    private static Optional<String> disabledReason(@Nullable Material material) {
        return material == null ? Optional.of(Messages.tr(NO_MATERIAL)) : Optional.empty();
    }

    private <V> List<Row> rows(MaterialAttribute<V> attribute) {
        return switch (attribute.kind()) {
            case NumericKind<V> q -> switch (q.form()) {
                case COLOR -> List.of(color(attribute, q));
                case INDEPENDENT -> IntStream.range(0, q.labels().size()).mapToObj(i -> number(attribute, q, i)).toList();
                case POSITION, DIRECTION -> List.of(vector(attribute, q));
            };
            case ValueKind.TextureKind _ -> List.of(texture(attribute.asMap().orElseThrow()));
            case ChoiceKind<V> c -> List.of(choice(attribute, c));
            case ValueKind.NameKind kind -> List.of(bulb(kind));
        };
    }

    private <V> Row color(MaterialAttribute<V> attribute, NumericKind<V> q) {
        ColorSliders sliders = new SurfaceColor<>(editor, materials, attribute, q).sliders();
        return new Row(attribute, sliders, sliders::setDisabledReason, m -> sliders.show(q.color(attribute.get(m))), sliders::showNothing,
                sliders::revert);
    }

    private <V> Row number(MaterialAttribute<V> attribute, NumericKind<V> q, int index) {
        String label = q.labels().get(index);
        String title = label.isEmpty() ? attribute.title() : attribute.title() + " " + label;
        ArrowWidget widget = new ArrowWidget(SectionLayout.title(label.isEmpty() ? title : label), title,
                NumberSetting.of(title, new StepRange(q.step(), q.min(), q.max()), q.unit(),
                        (v, gesture) -> editor.edit(scene -> MaterialEdits.edit(scene, shownName,
                                m -> attribute.with(m, q.with(attribute.get(m), index, v))), gesture)));
        widget.setId(label.isEmpty() ? attribute.id() : attribute.id() + " " + label);
        return new Row(attribute, widget, widget::setDisabledReason, m -> widget.show(q.number(attribute.get(m), index)),
                widget::showNothing,
                widget::revert);
    }

    private <V> Row vector(MaterialAttribute<V> attribute, NumericKind<V> q) {
        var field = new VectorField(attribute.title(), (v, gesture) -> editor.edit(scene -> MaterialEdits.edit(scene, shownName,
                m -> attribute.with(m, q.compose().apply(List.of(v.x(), v.y(), v.z())))), gesture));
        field.setId(attribute.id());
        return new Row(attribute, field, field::setDisabledReason, m -> field.show(q.vector(attribute.get(m))), field::showNothing,
                field::revert);
    }

    private <V> Row choice(MaterialAttribute<V> attribute, ChoiceKind<V> choice) {
        var box = new AttributeChoiceBox<>(attribute, choice, Messages.tr(attribute.help()),
                v -> editor.edit(scene -> MaterialEdits.set(scene, shownName, attribute, v), null));
        Node node = attribute.section() == Section.MODEL ? box : labeled(SectionLayout.title(attribute.title()), box);
        return new Row(attribute, node, box::setDisabledReason, m -> box.show(attribute.get(m)), box::showNothing, () -> {});
    }

    private Row bulb(ValueKind.NameKind kind) {
        var box = new NameChoice(editor, MaterialAttribute.BULB.id(), MaterialAttribute.BULB.title(), kind,
                light -> editor.editOrReport(scene -> MaterialEdits.setBulb(scene, shownName, light)));
        Node node = labeled(SectionLayout.title(MaterialAttribute.BULB.title()), box, box.box());
        return new Row(MaterialAttribute.BULB, node, box::setDisabledReason, m -> box.show(editor.scene(), m.bulb().light()),
                () -> box.show(editor.scene(), null), () -> {});
    }

    static Node labeled(String title, AttributeChoiceBox<?> box) {
        return labeled(title, box, box.box());
    }

    /** Puts a label to the left of a box. A section with a single box needs none. */
    private static Node labeled(String title, Node box, Node control) {
        var label = new Label(title);
        label.setLabelFor(control);
        var gap = new Region();
        HBox.setHgrow(gap, Priority.ALWAYS);
        var row = new HBox(label, gap, box);
        row.setAlignment(Pos.CENTER_LEFT);
        return row;
    }

    private Row texture(MaterialAttribute<Optional<TextureMap>> attribute) {
        var field = new TextureField(editor, commands, files, attribute);
        // The field detects a change of material itself.
        return new Row(attribute, field, field::setDisabledReason, field::show, field::showNothing, () -> {});
    }

    private void show(@Nullable Material material) {
        Optional<String> reason = disabledReason(material);
        rows.forEach(row -> row.setDisabledReason().accept(reason));
        nameReason.set(reason);
        if (material == null) {
            showNothing();
            return;
        }
        if (!material.name().equals(shownName)) {
            // Uncommitted input belongs to the other material.
            rows.forEach(row -> row.revert().run());
        }
        shownName = material.name();
        sections.forEach(part -> part.showApplicable(material));
        showNames();
        rows.forEach(row -> row.show().accept(material));
    }

    private void showNothing() {
        shownName = "";
        usersMaterial = "";
        users.setText("");
        isUpdating = true;
        name.setValue(null);
        isUpdating = false;
        rows.forEach(row -> row.showNothing().run());
    }

    private void showNames() {
        isUpdating = true;
        List<String> names = MaterialSelection.names(editor.scene());
        if (!name.getItems().equals(names)) {
            name.getItems().setAll(names);
        }
        name.setValue(shownName);
        isUpdating = false;
        if (!shownName.equals(usersMaterial) || editor.scene().nodes() != usersNodes) {
            updateUsers();
        }
    }

    /**
     * Updates the shapes that use the material. Scans all shapes, in the background if there are many; skipped for edits of the material
     * itself.
     */
    private void updateUsers() {
        usersMaterial = shownName;
        usersNodes = editor.scene().nodes();
        Scene scene = editor.scene();
        if (scene.stage().shapeCount() <= MAX_INLINE_SHAPES) {
            showUsers(MaterialSelection.shapesWith(scene, shownName));
        } else if (!isCounting) {
            isCounting = true;
            String material = shownName;
            files.files().runConcurrently(() -> MaterialSelection.shapesWith(scene, material), shapes -> {
                isCounting = false;
                if (material.equals(usersMaterial) && scene.nodes() == usersNodes) {
                    showUsers(shapes);
                } else if (!usersMaterial.isEmpty()) {
                    updateUsers();
                }
            }, _ -> isCounting = false);
        }
    }

    private void showUsers(List<String> shapes) {
        users.setText(
                shapes.isEmpty() ? Messages.tr("Not used by any object")
                        : Messages.tr("Used by {0}", String.join(", ", shapes.subList(0, Math.min(MAX_NAMES, shapes.size()))))
                                + (shapes.size() > MAX_NAMES ? Messages.tr(" and {0} more", shapes.size() - MAX_NAMES) : ""));
    }
}
