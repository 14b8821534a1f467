package lightning.render.trace;

import static org.assertj.core.api.Assertions.assertThat;

import java.lang.reflect.Array;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import java.util.Set;
import java.util.stream.IntStream;
import lightning.base.math.Rgb;
import lightning.base.math.Vec3;
import lightning.scene.Camera;
import lightning.scene.PictureSettings;
import lightning.scene.Scene;
import lightning.scene.World;
import lightning.scene.asset.Texture;
import lightning.scene.asset.TextureMap;
import lightning.scene.material.Anisotropy;
import lightning.scene.material.Coat;
import lightning.scene.material.Material;
import lightning.scene.material.MaterialAttribute;
import lightning.scene.material.ShadingModel;
import lightning.scene.material.Transmission;
import lightning.scene.node.Shape;
import lightning.scene.node.Solid;
import lightning.scene.value.Placement;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.IntRange;
import org.junit.jupiter.api.Test;

/** Tests that spliced rows keep all values in every column. */
class RowSpliceTest {
    private static final int MATERIALS = 4;
    private static final int PARENTS = 200;

    @Property
    void eachColumn_followsItsRow(@ForAll Random random, @ForAll @IntRange(min = 1, max = 100) int known,
            @ForAll @IntRange(max = 100) int more) {
        MaterialTable before = materials(random);
        MaterialTable after = materials(random);
        List<Short> parents = new ArrayList<>();
        for (short p = 0; p < PARENTS; p++) {
            parents.add(p);
        }
        Collections.shuffle(parents, random);
        HitRows old = rows(random, parents.subList(0, known), before);
        HitRows added = more == 0 ? null : rows(random, parents.subList(known, known + more), after);

        HitRows now = RowSplice.join(PARENTS, old, added, after).rows();
        boolean isAnisotropic = IntStream.range(0, now.runCount).anyMatch(r -> after.material(now.runMaterial[r]).isAnisotropic());

        assertThat(now.count).isEqualTo(known + more);
        assertThat(now.clearCount).isEqualTo(old.clearCount + (added == null ? 0 : added.clearCount));
        for (int i = 0; i < now.count; i++) {
            HitRows origin = rowOf(old, now.parent[i]) >= 0 ? old : added;
            int row = rowOf(origin, now.parent[i]);
            assertThat(material(now, i)).isEqualTo(material(origin, row));
            for (HitRows.Column column : columns(now, isAnisotropic)) {
                assertThat(Array.get(now.columns().get(column), i)).as(column + " of row " + i)
                        .isEqualTo(Array.get(origin.columns().get(column), row));
            }
        }
    }

    /** Returns all columns, with those of refraction, of tangents and of coats if they exist. */
    private static List<HitRows.Column> columns(HitRows rows, boolean tangents) {
        return Arrays.stream(HitRows.Column.values())
                .filter(column -> tangents || !HitRows.ColumnGroup.TANGENT.columns().contains(column))
                .filter(column -> rows.clearCount > 0 || !HitRows.ColumnGroup.TRANSPARENT.columns().contains(column))
                // Only clear rows may be left, which have no coat.
                .filter(column -> rows.columns().has(column) || !HitRows.ColumnGroup.COAT_NORMAL.columns().contains(column)).toList();
    }

    @Test
    void eachRowArray_isColumn() {
        HitRows rows = new HitRows(1, TexelColumns.ALL, true, true, true);
        long arrays = Arrays.stream(HitRows.class.getFields()).filter(f -> f.getType().isArray())
                .filter(f -> !f.getName().startsWith("run")).count();
        Set<float[]> texels = Collections.newSetFromMap(new IdentityHashMap<>());
        for (HitRows.ColumnGroup group : HitRows.ColumnGroup.TEXELS) {
            IntStream.range(0, group.columnCount()).forEach(c -> texels.add(rows.texel(group, c)));
        }
        assertThat(texels).hasSize(HitRows.ColumnGroup.TEXELS.stream().mapToInt(HitRows.ColumnGroup::columnCount).sum())
                .contains(rows.texelRed, rows.texelGreen, rows.texelBlue);
        // Only textures have fields, of all texels.
        assertThat(arrays).isEqualTo(HitRows.Column.values().length - texels.size() + 3);
        assertThat(HitRows.Column.values()).allMatch(column -> rows.columns().has(column));
    }

    /** Returns rows of random materials with random values in all columns. */
    private static HitRows rows(Random random, List<Short> parents, MaterialTable materials) {
        HitRows rows = new HitRows(parents.size(), TexelColumns.ALL, true, true, true);
        rows.count = parents.size();
        for (HitRows.Column column : HitRows.Column.values()) {
            Object array = rows.columns().get(column);
            for (int i = 0; i < rows.count; i++) {
                switch (column.element()) {
                    case BYTE -> Array.setByte(array, i, (byte) random.nextInt());
                    case SHORT -> Array.setShort(array, i, (short) random.nextInt());
                    case INT -> Array.setInt(array, i, random.nextInt());
                    case FLOAT -> Array.setFloat(array, i, random.nextFloat());
                }
            }
        }
        List<Integer> ranks = new ArrayList<>();
        for (int i = 0; i < rows.count; i++) {
            rows.parent[i] = parents.get(i);
            ranks.add(random.nextInt(MATERIALS));
        }
        Collections.sort(ranks);
        for (int i = 0; i < rows.count; i++) {
            if (i + 1 == rows.count || !ranks.get(i).equals(ranks.get(i + 1))) {
                rows.addRun(materials.materialAtRank(ranks.get(i)), i + 1);
            }
        }
        rows.reflectiveCount = (int) ranks.stream().filter(rank -> rank < materials.reflectiveCount()).count();
        rows.clearCount = (int) ranks.stream().filter(rank -> rank < materials.clearCount()).count();
        return rows;
    }

    private static int rowOf(HitRows rows, short parent) {
        for (int i = 0; rows != null && i < rows.count; i++) {
            if (rows.parent[i] == parent) {
                return i;
            }
        }
        return -1;
    }

    private static int material(HitRows rows, int row) {
        int run = 0;
        while (row >= rows.runEnd[run]) {
            run++;
        }
        return rows.runMaterial[run];
    }

    /** Creates textured materials, so that texels are stored; some are reflective, and one is clear. */
    private static MaterialTable materials(Random random) {
        Texture texture = new Texture(1, 1, new float[] {1, 1, 1});
        List<String> names = new ArrayList<>();
        List<Material> materials = new ArrayList<>();
        for (int m = 0; m < MATERIALS; m++) {
            names.add("m" + m);
            materials.add(Material.of("m" + m).withModel(ShadingModel.PRINCIPLED).withRoughness(m == 1 ? 0 : random.nextInt(2))
                    .withAnisotropy(new Anisotropy(0.5, 0))
                    .withCoat(new Coat(1, 0.5, 1.5))
                    .withTransmission(m == 1 ? Transmission.NONE.withColor(Rgb.WHITE) : Transmission.NONE)
                    .withTexture(Optional.of(new TextureMap("t.png", 1, 1, texture))));
            for (MaterialAttribute<Optional<TextureMap>> map : MaterialAttribute.MAPS) {
                if (map.term().changesTexels()) {
                    materials.set(m, map.with(materials.get(m), Optional.of(new TextureMap("t.png", 1, 1, texture))));
                }
            }
            materials.set(m, MaterialAttribute.COAT_NORMAL_MAP.with(materials.get(m), Optional.of(new TextureMap("t.png", 1, 1, texture))));
        }
        var plane = new Shape(Solid.PLANE, "p", "m0", Placement.IDENTITY);
        Camera camera = new Camera(Vec3.ZERO, new Vec3(0, 0, -1), Vec3.Y, 40);
        return new MaterialTable(names, Set.of(),
                new Scene(PictureSettings.DEFAULT, camera, World.DEFAULT, materials, List.of(plane), List.of()),
                null, MaterialTable.CASTS_REFLECTIONS);
    }
}
