/* Files laid into the program as they are; CMake says where they are. */
.macro embed name, file
  .global \name\()_begin
  .global \name\()_end
\name\()_begin:
  .incbin "\file"
\name\()_end:
  .byte 0
.endm

.section .rodata
embed artcal_plotly, ARTCAL_PLOTLY_BUNDLE
embed artcal_plotly_licence, ARTCAL_PLOTLY_LICENCE
embed artcal_figures, ARTCAL_FIGURES
embed artcal_missing, ARTCAL_MISSING
embed artcal_sorting, ARTCAL_SORTING
embed artcal_style, ARTCAL_STYLE

.section .note.GNU-stack, "", %progbits
