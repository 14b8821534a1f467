package lightning.editor.window.command;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import javafx.geometry.Pos;
import javafx.scene.control.Button;
import javafx.scene.control.ContentDisplay;
import javafx.scene.control.Label;
import javafx.scene.image.Image;
import javafx.scene.image.ImageView;
import javafx.scene.layout.HBox;
import javafx.scene.layout.VBox;
import javafx.scene.text.TextAlignment;
import lightning.base.text.Messages;
import lightning.document.imports.ImportPreviews.Choice;
import lightning.document.imports.ImportPreviews.Preview;
import lightning.editor.window.widget.PixelImage;
import lightning.format.exchange.ImportLighting;
import lightning.format.exchange.assembly.LightUnits;
import lightning.scene.PictureSettings;

/**
 * Buttons for the lighting of an imported scene, each with a preview: the file's own lights, in each possible unit of their intensities, a
 * studio and a sky.
 */
final class ImportChooser extends VBox {
    private static final double GAP = 12;

    private final Map<Choice, Button> cards = new LinkedHashMap<>();
    private Optional<Choice> chosen = Optional.empty();

    /**
     * Shows choices without their pictures: see {@link #show}.
     *
     * @param picture   size of the previews
     * @param maxWidth  maximum width in logical pixels; the previews shrink to fit
     * @param onChosen  runs after a choice
     */
    ImportChooser(List<Choice> choices, PictureSettings picture, double maxWidth, Runnable onChosen) {
        super(GAP);
        boolean hasUnits = choices.stream().anyMatch(choice -> choice.units().isPresent());
        var explanation = new Label(hasUnits
                ? Messages.tr(
                        "The file does not state the unit of its light intensities, which Blender chooses by the Lighting Mode of its export. These previews leave out textures and blurred reflections.")
                : Messages.tr("These previews leave out textures and blurred reflections."));
        explanation.setWrapText(true);
        double width = Math.min(picture.width(), (maxWidth - GAP) / choices.size() - 3 * GAP);
        for (Choice choice : choices) {
            cards.put(choice, card(choice, width, width * picture.height() / picture.width(), onChosen));
        }
        var row = new HBox(GAP);
        row.getChildren().addAll(cards.values());
        // The text wraps at the width of the cards.
        explanation.prefWidthProperty().bind(row.widthProperty());
        explanation.setMaxWidth(USE_PREF_SIZE);
        getChildren().setAll(explanation, row);
    }

    /** @param width  width of the picture; leaves more than half a gap between a card's edge and its picture */
    private Button card(Choice choice, double width, double height, Runnable onChosen) {
        var waiting = new Label(Messages.tr("Previewing"));
        waiting.setAlignment(Pos.CENTER);
        waiting.setMinSize(width, height);
        waiting.setPrefSize(width, height);
        // Room for an exposure, so that the card keeps its size.
        var card = new Button(title(choice) + (choice.lighting() == ImportLighting.FILE ? "\n\u00a0" : ""), waiting);
        card.setPrefWidth(width + 2 * GAP);
        card.setMaxHeight(Double.MAX_VALUE);
        card.setAlignment(Pos.TOP_CENTER);
        card.setWrapText(true);
        card.setTextAlignment(TextAlignment.CENTER);
        card.setId(choice.units().map(units -> "units-" + units.name())
                .orElse("lighting-" + choice.lighting().name()).toLowerCase(Locale.ROOT));
        card.setContentDisplay(ContentDisplay.TOP);
        card.setAccessibleText(
                choice.units().map(units -> Messages.tr("Read intensities as {0}", units.description())).orElse(title(choice)));
        card.setOnAction(_ -> {
            chosen = Optional.of(choice);
            onChosen.run();
        });
        return card;
    }

    /** Shows the preview of a choice. */
    void show(Choice choice, Preview preview) {
        Button card = cards.get(choice);
        if (card != null) {
            var picture = new ImageView(image(preview));
            picture.setPreserveRatio(true);
            picture.setFitWidth(card.getPrefWidth() - 2 * GAP);
            card.setGraphic(picture);
            card.setText(title(choice) + exposure(preview));
        }
    }

    /** Removes a choice, unless it is the last. */
    void remove(Choice choice) {
        Button card = cards.get(choice);
        if (card != null && cards.size() > 1) {
            cards.remove(choice);
            card.setVisible(false);
            card.setManaged(false);
        }
    }

    /** Returns the choice, or empty. */
    Optional<Choice> chosen() {
        return chosen;
    }

    private static String title(Choice choice) {
        return switch (choice.lighting()) {
            case STUDIO -> Messages.tr("Studio");
            case SKY -> Messages.tr("Sky");
            case SOFTBOXES, STRIPS, RING -> Messages.tr("Photo Studio");
            case FILE -> choice.units().map(units -> Messages.tr("The file's lights: {0}", unitTitle(units)))
                    .orElse(Messages.tr("The file's lights"));
        };
    }

    private static String unitTitle(LightUnits units) {
        return switch (units) {
            case CANDELA -> Messages.tr("as the glTF standard says (Blender: Standard)");
            case UNITLESS -> Messages.tr("without a unit (Blender: Unitless)");
            case WATTS -> Messages.tr("Blender's watts (Blender: Raw)");
        };
    }

    private static String exposure(Preview preview) {
        return preview.exposure() == 0 ? "" : "\n" + Messages.tr("exposure {0} stops", (int) preview.exposure());
    }

    private static Image image(Preview preview) {
        return PixelImage.of(preview.film().width(), preview.film().height(), preview.pixels());
    }
}
