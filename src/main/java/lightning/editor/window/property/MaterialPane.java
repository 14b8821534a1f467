package lightning.editor.window.property;

import java.util.Arrays;
import java.util.EnumMap;
import java.util.EnumSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Stream;
import javafx.geometry.Pos;
import javafx.scene.Node;
import javafx.scene.control.Label;
import javafx.scene.control.ScrollPane;
import javafx.scene.control.TitledPane;
import javafx.scene.layout.HBox;
import javafx.scene.layout.Priority;
import javafx.scene.layout.Region;
import javafx.scene.layout.VBox;
import lightning.base.text.Messages;
import lightning.document.EditOutcome;
import lightning.document.MaterialEdits;
import lightning.editor.Command;
import lightning.editor.window.command.CommandButton;
import lightning.editor.window.model.EditorModel;
import lightning.editor.window.model.MaterialSelection;
import lightning.scene.Scene;
import lightning.scene.SceneElement;
import lightning.scene.attribute.PlacementAttribute;
import lightning.scene.attribute.SceneAttribute;
import lightning.scene.attribute.ValueKind;
import lightning.scene.material.Material;
import lightning.scene.material.MaterialAttribute;
import lightning.scene.material.MaterialAttribute.Section;
import lightning.scene.node.SceneNode;

/** Property editor of a material. Edits affect every shape that uses it. */
final class MaterialPane extends AttributeForm<Material> {
    private static final int MAX_NAMES = 4;
    /** Maximum number of shapes to scan on the window's thread, which takes tens of microseconds. */
    private static final int MAX_INLINE_SHAPES = 1000;

    /** Sections that are always unfolded at first; others only if their material uses them. */
    private static final Set<Section> COMMON =
            EnumSet.of(Section.MODEL, Section.DIFFUSE, Section.BASE, Section.SPECULAR, Section.SURFACE, Section.TEXTURE);

    private final Map<Section, TitledPane> sections = new EnumMap<>(Section.class);
    /** Sections that the user unfolded (true) or folded: they stay so for every material. */
    private final Map<Section, Boolean> chosenSections = new EnumMap<>(Section.class);
    /** Material whose sections were last folded or unfolded; empty before the first. */
    private String foldedFor = "";
    private boolean isFolding;
    private final ChoiceField<String> name;
    private final Label users = new Label();
    /** Material and nodes that {@link #users} describes. */
    private String usersMaterial = "";
    private List<SceneNode> usersNodes = List.of();
    private boolean isCounting;

    /** @param menu  context menu of the properties */
    MaterialPane(EditorModel model, PropertyMenu menu) {
        super(model, menu);
        setId("material");
        getStyleClass().add("properties");
        name = new ChoiceField<>("material-name", Messages.tr("material"),
                Messages.tr("Material to edit; affects every object that uses it"), _ -> MaterialSelection.names(editor.scene()),
                material -> material, model.materials()::choose);
        HBox.setHgrow(name, Priority.ALWAYS);
        var row = new HBox(name, CommandButton.iconButton(model.commands(), Command.PICK_MATERIAL));
        row.getStyleClass().add("header-row");
        users.setId("material-users");
        users.getStyleClass().add("caption");
        users.setWrapText(true);
        var header = new VBox(row, users);
        header.getStyleClass().add("light-header");
        var library = new MaterialLibraryPane(editor, model.materials(), model.fileImporter().files().windowExecutor());
        ScrollPane scroll = SectionLayout.incrementalScroll(box -> Stream.concat(Stream.of(() -> SectionLayout.add(box, header),
                () -> SectionLayout.add(box, library.section())),
                Arrays.stream(Section.values()).flatMap(section -> sectionSteps(box, section))));
        setVgrow(scroll, Priority.ALWAYS);
        getChildren().add(scroll);
        model.materials().materialProperty().subscribe(_ -> showMaterial());
        editor.sceneProperty().subscribe((before, now) -> {
            if (!MaterialSelection.haveSameMaterials(before, now)) {
                showMaterial();
            }
        });
    }

    /** Returns steps that create a section and then its widgets one by one. */
    private Stream<Runnable> sectionSteps(VBox box, Section section) {
        List<MaterialAttribute<?>> attributes = attributes(section);
        TitledPane pane = SectionLayout.section(SectionLayout.title(section.title()));
        sections.put(section, pane);
        record().ifPresent(material -> fold(material, section, pane));
        pane.expandedProperty().subscribe((_, isExpanded) -> {
            if (!isFolding) {
                chosenSections.put(section, isExpanded);
            }
        });
        onlyIf(material -> attributes.stream().anyMatch(a -> isShown(a, material)), List.of(pane));
        return Stream.concat(Stream.of(() -> SectionLayout.add(box, pane)), attributes.stream()
                .map(a -> () -> rows(a).forEach(node -> SectionLayout.add(SectionLayout.content(pane), node))));
    }

    private static List<MaterialAttribute<?>> attributes(Section section) {
        return MaterialAttribute.ALL.stream().filter(a -> a.section() == section).toList();
    }

    private static boolean isUsed(Section section, Material material) {
        return COMMON.contains(section) || attributes(section).stream().anyMatch(a -> !a.get(material).equals(a.initial()));
    }

    /** Unfolds the sections that a material uses. The others are only folded when another material was shown before. */
    private void fold(Material material) {
        isFolding = true;
        boolean isOther = !material.name().equals(foldedFor);
        foldedFor = material.name();
        sections.forEach((section, pane) -> {
            if (isOther || isUsed(section, material)) {
                fold(material, section, pane);
            }
        });
        isFolding = false;
    }

    private void fold(Material material, Section section, TitledPane pane) {
        pane.setExpanded(chosenSections.getOrDefault(section, isUsed(section, material)));
    }

    @Override
    Optional<SceneElement<Material>> selected() {
        return Optional.ofNullable(model.materials().material()).map(material -> new SceneElement.OfMaterial(material.name()));
    }

    @Override
    String missingReason() {
        return Messages.tr("the scene has no objects");
    }

    @Override
    boolean isShown(SceneAttribute<Material, ?> attribute, Material material) {
        return !(attribute instanceof MaterialAttribute<?> own) || own.appliesTo(material.model()) && !own.isPartOfNothing(material);
    }

    @Override
    String id(SceneAttribute<Material, ?> attribute, String part) {
        String id = super.id(attribute, part);
        return attribute instanceof PlacementAttribute ? id.replace('_', '-').replace(' ', '-') : id;
    }

    @Override
    String title(SceneAttribute<Material, ?> attribute) {
        return !(attribute instanceof PlacementAttribute<Material, ?> placed) ? attribute.title()
                : placed.kind() == ValueKind.TextureKind.WRAP ? Messages.tr("{0}: beyond its edges", placed.texture().title())
                : placed.name();
    }

    @Override
    String label(SceneAttribute<Material, ?> attribute, String part) {
        return attribute instanceof PlacementAttribute && !part.isEmpty()
                ? Messages.tr(attribute.title()) + " " + part.toUpperCase(Locale.ROOT) : super.label(attribute, part);
    }

    @Override
    String help(SceneAttribute<Material, ?> attribute) {
        return attribute instanceof MaterialAttribute<?> own ? Messages.tr(own.help())
                : Messages.tr("What a surface shows beyond the edges of an image; the first word is for left and right");
    }

    /** Puts the name to the left of a box. A section with a single box needs none. */
    @Override
    List<Node> titled(SceneAttribute<Material, ?> attribute, Node widget) {
        if (attribute == MaterialAttribute.MODEL) {
            return List.of(widget);
        }
        var label = new Label(SectionLayout.title(attribute.title()));
        label.setLabelFor(widget instanceof ChoiceField<?> field ? field.box() : widget);
        var gap = new Region();
        HBox.setHgrow(gap, Priority.ALWAYS);
        var row = new HBox(label, gap, widget);
        row.setAlignment(Pos.CENTER_LEFT);
        attachMenu(row, attribute);
        return List.of(row);
    }

    @Override
    <V> EditOutcome choose(Scene scene, SceneElement<Material> element, SceneAttribute<Material, V> attribute, V value) {
        return attribute == MaterialAttribute.BULB ? MaterialEdits.setBulb(scene, element.name(), (String) value)
                : super.choose(scene, element, attribute, value);
    }

    private void showMaterial() {
        discardInput();
        show();
        Optional<Material> material = record();
        material.ifPresent(this::fold);
        name.setDisabledReason(material.isPresent() ? Optional.empty() : Optional.of(missingReason()));
        material.map(Material::name).ifPresentOrElse(this::showName, () -> {
            name.showNothing();
            usersMaterial = "";
            users.setText("");
        });
    }

    private void showName(String material) {
        name.show(material);
        if (!material.equals(usersMaterial) || editor.scene().nodes() != usersNodes) {
            updateUsers(material);
        }
    }

    /**
     * Updates the shapes that use the material. Scans all shapes, in the background if there are many; skipped for edits of the material
     * itself.
     */
    private void updateUsers(String material) {
        usersMaterial = material;
        usersNodes = editor.scene().nodes();
        Scene scene = editor.scene();
        if (scene.stage().shapeCount() <= MAX_INLINE_SHAPES) {
            showUsers(MaterialSelection.shapesWith(scene, material));
        } else if (!isCounting) {
            isCounting = true;
            model.fileImporter().files().runConcurrently(() -> MaterialSelection.shapesWith(scene, material), shapes -> {
                isCounting = false;
                if (material.equals(usersMaterial) && scene.nodes() == usersNodes) {
                    showUsers(shapes);
                } else if (!usersMaterial.isEmpty()) {
                    updateUsers(usersMaterial);
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
