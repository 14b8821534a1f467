package lightning.editor.window.command;

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
import lightning.editor.window.widget.PixelImage;
import lightning.format.exchange.ImportPreviews.Choice;
import lightning.format.exchange.ImportPreviews.Preview;
import lightning.format.exchange.assembly.LightUnits;
import lightning.render.image.Film;
import lightning.render.image.ViewTransform;

/**
 * Buttons for the lighting of an imported scene, each with a preview: the file's own lights, in each possible unit of their intensities, a
 * studio and a sky.
 */
final class ImportChooser extends VBox {
    private static final double GAP = 12;

    private Optional<Choice> chosen = Optional.empty();

    /**
     * @param maxWidth  maximum width in logical pixels; the previews shrink to fit
     * @param onChosen  runs after a choice
     */
    ImportChooser(Map<Choice, Preview> pictures, double maxWidth, Runnable onChosen) {
        super(GAP);
        boolean hasUnits = pictures.keySet().stream().anyMatch(choice -> choice.units().isPresent());
        var explanation = new Label(hasUnits
                ? Messages.tr(
                        "The file does not state the unit of its light intensities, which Blender chooses by the Lighting Mode of its export. These previews leave out textures.")
                : Messages.tr("These previews leave out textures."));
        explanation.setWrapText(true);
        var cards = new HBox(GAP);
        double widest = pictures.values().stream().mapToInt(preview -> preview.film().width()).max().orElse(1);
        pictures.forEach((choice, preview) -> cards.getChildren()
                .add(card(choice, preview, Math.min(widest, (maxWidth - GAP) / pictures.size() - 3 * GAP), onChosen)));
        // The text wraps at the width of the cards.
        explanation.prefWidthProperty().bind(cards.widthProperty());
        explanation.setMaxWidth(USE_PREF_SIZE);
        getChildren().setAll(explanation, cards);
    }

    /** @param width  width of the picture; leaves more than half a gap between a card's edge and its picture */
    private Button card(Choice choice, Preview preview, double width, Runnable onChosen) {
        var picture = new ImageView(image(preview));
        picture.setPreserveRatio(true);
        picture.setFitWidth(width);
        var card = new Button(title(choice) + exposure(preview), picture);
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

    /** Returns the choice, or empty. */
    Optional<Choice> chosen() {
        return chosen;
    }

    private static String title(Choice choice) {
        return switch (choice.lighting()) {
            case STUDIO -> Messages.tr("Studio");
            case SKY -> Messages.tr("Sky");
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
        Film film = preview.film();
        return PixelImage.of(film.width(), film.height(), ViewTransform.DEFAULT.withExposure(preview.exposure()).toPixels(film));
    }
}
