# SPDX-License-Identifier: Apache-2.0
# Before CPack packs: everybody may read what is installed, whatever the umask of who packs.
execute_process(COMMAND chmod -R u=rwX,go=rX ${CPACK_TEMPORARY_INSTALL_DIRECTORY} COMMAND_ERROR_IS_FATAL ANY)
