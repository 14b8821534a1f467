package lightning.editor.window.widget;

import java.util.Locale;
import javafx.util.StringConverter;
import lightning.base.text.Messages;
import lightning.scene.light.LightType;
import org.jspecify.annotations.Nullable;
import org.kordamp.ikonli.Ikon;
import org.kordamp.ikonli.materialdesign2.MaterialDesignC;
import org.kordamp.ikonli.materialdesign2.MaterialDesignL;
import org.kordamp.ikonli.materialdesign2.MaterialDesignS;
import org.kordamp.ikonli.materialdesign2.MaterialDesignW;

/** Icons and titles of the light types. */
public final class LightTypes {
    public static final StringConverter<LightType> CONVERTER = new StringConverter<>() {
        @Override
        public String toString(@Nullable LightType type) {
            return type == null ? "" : title(type);
        }

        @Override
        public LightType fromString(String text) {
            return LightType.valueOf(text.toUpperCase(Locale.ROOT));
        }
    };

    private LightTypes() {}

    public static String title(LightType type) {
        return switch (type) {
            case POINT -> Messages.tr("Point");
            case SPOT -> Messages.tr("Spot");
            case DIRECTIONAL -> Messages.tr("Directional");
            case RECT -> Messages.tr("Rectangle");
            case DISC -> Messages.tr("Disc");
            case TUBE -> Messages.tr("Tube");
            case OBJECT -> Messages.tr("Object");
        };
    }

    /** Returns the type within a sentence, for example {@code spot light}. */
    public static String phrase(LightType type) {
        return switch (type) {
            case POINT -> Messages.tr("point light");
            case SPOT -> Messages.tr("spot light");
            case DIRECTIONAL -> Messages.tr("directional light");
            case RECT -> Messages.tr("rectangle area light");
            case DISC -> Messages.tr("disc area light");
            case TUBE -> Messages.tr("tube light");
            case OBJECT -> Messages.tr("object light");
        };
    }

    public static Ikon icon(LightType type) {
        return switch (type) {
            case POINT -> MaterialDesignL.LIGHTBULB_ON_OUTLINE;
            case SPOT -> MaterialDesignS.SPOTLIGHT_BEAM;
            case DIRECTIONAL -> MaterialDesignW.WHITE_BALANCE_SUNNY;
            case RECT -> MaterialDesignC.CARD_OUTLINE;
            case DISC -> MaterialDesignC.CIRCLE_OUTLINE;
            case TUBE -> MaterialDesignL.LIGHTBULB_FLUORESCENT_TUBE_OUTLINE;
            case OBJECT -> MaterialDesignC.CUBE_OUTLINE;
        };
    }

    /** Returns the icon of a light that is on or off. */
    public static Ikon onIcon(boolean on) {
        return on ? MaterialDesignL.LIGHTBULB_ON : MaterialDesignL.LIGHTBULB_OFF_OUTLINE;
    }
}
