package lightning.editor.window.property;

import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import javafx.beans.value.ObservableValue;
import javafx.scene.Node;
import javafx.scene.control.Button;
import javafx.scene.control.Tooltip;
import javafx.scene.layout.HBox;
import lightning.base.text.Messages;
import lightning.document.DomeEdits;
import lightning.document.EditOutcome;
import lightning.editor.Command;
import lightning.editor.EditorState;
import lightning.editor.window.model.EditorModel;
import lightning.format.jen.asset.FileKind;
import lightning.scene.Dome;
import lightning.scene.SceneElement;
import lightning.scene.attribute.NumericKind;
import lightning.scene.attribute.SceneAttribute;

/** Further environments of the scene: a list, a menu that adds one, and the settings of the selected one. */
final class DomeForm extends AttributeForm<Dome> {
    private final ChoiceField<String> list;
    private final Node rows;
    /** Name of the selected dome; empty for none. */
    private String name = "";
    /** Names of the domes that are listed. */
    private List<String> listed = List.of();

    DomeForm(EditorModel model, ObservableValue<EditorState> visibleState) {
        super(model, null);
        getStyleClass().add("section-rows");
        list = new ChoiceField<>("domes", Messages.tr("Domes"), "", _ -> listed, name -> name, chosen -> {
            name = chosen;
            discardInput();
            show();
        });
        var delete = new Button(Messages.tr("Delete Dome"));
        delete.setId("delete-dome");
        delete.setOnAction(_ -> selected().ifPresent(dome -> editor.editOrReport(scene -> EditOutcome.of(() -> dome.delete(scene)))));
        var switches = new HBox(check(Dome.ON), check(Dome.SOLO), delete);
        switches.getStyleClass().add("switches");
        rows = SectionLayout.column(List.of(file(Dome.ENVIRONMENT), switches), Dome.ATTRIBUTES.stream()
                .filter(attribute -> attribute.kind() instanceof NumericKind).flatMap(attribute -> numbers(attribute).stream()).toList());
        Consumer<String> adder = file -> {
            if (!file.isEmpty()) {
                DomeFiles.add(model, file, DomeEdits::add);
            }
        };
        var add = new FileMenu(model, Messages.tr("Add Dome"), Command.CHOOSE_ENVIRONMENT, FileKind.ENVIRONMENT, () -> adder,
                editor.message()::show);
        add.setId("add-dome");
        add.setMaxWidth(Double.MAX_VALUE);
        add.setTooltip(new Tooltip(Messages.tr("Add an environment image whose light and picture are added to the others")));
        getChildren().addAll(list, rows, add);
        showWhile(visibleState);
    }

    @Override
    Optional<SceneElement<Dome>> selected() {
        return name.isEmpty() ? Optional.empty() : Optional.of(new SceneElement.OfDome(name));
    }

    @Override
    String missingReason() {
        return Messages.tr("the dome no longer exists");
    }

    @Override
    void show() {
        List<String> names = editor.scene().world().named().stream().map(Dome::name).toList();
        name = nextName(names);
        listed = names;
        if (name.isEmpty()) {
            list.showNothing();
        } else {
            list.show(name);
        }
        SectionLayout.setShown(list, !names.isEmpty());
        SectionLayout.setShown(rows, !names.isEmpty());
        super.show();
    }

    /** Returns the dome to select: a new one, the same as before, or the one at the place of one that is gone. */
    private String nextName(List<String> names) {
        Optional<String> added = names.stream().filter(other -> !listed.contains(other)).reduce((_, last) -> last);
        return names.isEmpty() ? "" : listed.isEmpty() ? names.getFirst()
                : added.orElseGet(() -> names.contains(name) ? name
                        : names.get(Math.clamp(listed.indexOf(name), 0, names.size() - 1)));
    }

    @Override
    String id(SceneAttribute<Dome, ?> attribute, String part) {
        return "dome-" + attribute.name();
    }

    @Override
    String label(SceneAttribute<Dome, ?> attribute, String part) {
        return attribute == Dome.ON ? Messages.tr("On") : attribute == Dome.SOLO ? Messages.tr("Solo") : attribute.title();
    }

    @Override
    String help(SceneAttribute<Dome, ?> attribute) {
        return attribute == Dome.ON ? Messages.tr("A dome that is off is neither seen nor lights anything")
                : Messages.tr("Mute all lights that are not solo");
    }
}
